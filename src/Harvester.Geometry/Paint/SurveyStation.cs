namespace Harvester.Geometry.Paint;

/// <summary>A place above which a road is photographed from above.</summary>
/// <param name="Ground">The point of the road under the camera, metres, world, at the height of the road network.</param>
/// <param name="Forward">Unit vector of the road's direction there, on the ground; the image's longer side lies along it.</param>
public readonly record struct SurveyStation(Vector3D Ground, Vector2D Forward)
{
    /// <summary>The heading of a vehicle that stands along the road there, degrees counter-clockwise from north, in [0, 360).</summary>
    public double HeadingDegrees => Angles.HeadingDegrees(new Vector3D(Forward.X, Forward.Y, 0));

    /// <summary>Whether a point of the ground lies in the footprint of the camera.</summary>
    /// <param name="place">Metres, world; the height is ignored.</param>
    /// <param name="footprint">The footprint.</param>
    public bool Shows(Vector3D place, SurveyFootprint footprint)
    {
        var apart = new Vector2D(place.X - Ground.X, place.Y - Ground.Y);
        return Math.Abs(apart.Dot(Forward)) <= footprint.HalfAlong && Math.Abs(apart.Cross(Forward)) <= footprint.HalfAcross;
    }
}
