namespace Harvester.Geometry.Paint;

/// <summary>The height of the ground under an image.</summary>
public interface IPaintGround
{
    /// <summary>The height of the ground at a place.</summary>
    /// <param name="place">A point at the height that the road network gives, metres, world.</param>
    /// <returns>Metres, world; NaN where it is unknown.</returns>
    double HeightAt(Vector3D place);

    /// <summary>The standard deviation of the height, metres.</summary>
    /// <param name="distance">Horizontal distance from the camera, metres.</param>
    double SigmaAt(double distance);
}
