using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// The vehicle frame of OpenLane and Waymo: fixed to the body, with its pitch and roll; its origin is on the road below the model's origin.
/// </summary>
internal static class VehicleFrame
{
    /// <summary>The pose of the frame, with axes right, forward, up.</summary>
    /// <param name="ego">The vehicle. Sessions of earlier versions have only its heading; their frame is level and at the model's
    /// origin.</param>
    public static Pose Of(EgoLabel ego)
    {
        Axes axes = ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees);

        // The height above the road is vertical; along the tilted up axis of the body, the distance is shorter.
        double height = (ego.HeightAboveGroundMetres ?? 0) * axes.Up.Z;
        return new Pose(ego.Position - (axes.Up * height), axes);
    }
}
