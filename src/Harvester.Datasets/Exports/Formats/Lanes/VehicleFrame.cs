using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Formats.Lanes;

/// <summary>
/// The frame of a vehicle as OpenLane and Waymo have it: fixed to the body, with its pitch and roll, its origin on the road below the
/// model's origin.
/// </summary>
internal static class VehicleFrame
{
    /// <summary>The pose of the frame, with axes right, forward, up.</summary>
    /// <param name="ego">The vehicle. Sessions of earlier versions know its heading alone: their frame is level and at the model's
    /// origin.</param>
    public static Pose Of(EgoLabel ego)
    {
        Axes axes = ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees);

        // The height is vertical; what lies below the origin along the body's up is less by the lean.
        double height = (ego.HeightAboveGroundMetres ?? 0) * axes.Up.Z;
        return new Pose(ego.Position - (axes.Up * height), axes);
    }
}
