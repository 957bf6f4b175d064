using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the labels of joints except their visibility, which comes from rays or from an earlier label.</summary>
internal static class JointLabels
{
    /// <summary>The joints of a person.</summary>
    /// <param name="camera">The camera of the saved image.</param>
    /// <param name="skeleton">The joints in the world.</param>
    /// <param name="visibilityOf">The visibility of a joint in the image.</param>
    public static JointsLabel Of(Camera camera, Skeleton skeleton, Func<Joint, JointVisibility> visibilityOf) =>
        new(
            [.. Enumerable.Range(0, Skeleton.Count).Select(number => Of(camera, skeleton, (Joint)number, visibilityOf))],
            SphereBox.Around(camera, skeleton.Joints, JointSizes.Radii)
        );

    /// <summary>
    /// The joints of a person as they were seen with another lens, or another range: a joint that was not in the image is undetermined.
    /// </summary>
    /// <param name="camera">The camera of the new label.</param>
    /// <param name="skeleton">The joints in the world.</param>
    /// <param name="recorded">The joints of the earlier label; null if the person had none.</param>
    public static JointsLabel Again(Camera camera, Skeleton skeleton, JointsLabel? recorded) =>
        Of(
            camera,
            skeleton,
            joint => recorded?[joint].Visibility is { } found and not JointVisibility.Outside ? found : JointVisibility.Unknown
        );

    private static JointLabel Of(Camera camera, Skeleton skeleton, Joint joint, Func<Joint, JointVisibility> visibilityOf)
    {
        Projection projection = camera.Project(skeleton[joint]);
        return new JointLabel(
            skeleton[joint],
            projection.Outcome == ProjectionOutcome.BehindNearPlane ? null : projection.Pixel,
            projection.Outcome == ProjectionOutcome.InImage ? visibilityOf(joint) : JointVisibility.Outside
        );
    }
}
