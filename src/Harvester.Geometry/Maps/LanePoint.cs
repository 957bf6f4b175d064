namespace Harvester.Geometry.Maps;

/// <summary>A point of the middle of a lane.</summary>
/// <param name="Position">Metres, world.</param>
/// <param name="Direction">Unit vector of the direction of travel on the ground.</param>
/// <param name="Along">Metres along the middle from where the lane begins.</param>
/// <param name="Width">Width of the lane there, metres.</param>
public readonly record struct LanePoint(Vector3D Position, Vector2D Direction, double Along, double Width)
{
    /// <summary>How far a place is to the right of the middle, metres.</summary>
    public double OffsetOf(Vector3D place) => -Direction.Cross(new Vector2D(place.X - Position.X, place.Y - Position.Y));
}
