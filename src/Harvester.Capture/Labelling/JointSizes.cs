using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>The size of the body around each joint, metres: of an adult of middle build, with clothes.</summary>
internal static class JointSizes
{
    private static readonly (double Radius, double Depth)[] Sizes =
    [
        .. Enumerable.Range(0, Skeleton.Count).Select(joint => SizeOf((Joint)joint)),
    ];

    /// <summary>Radius of the sphere about each joint that stands for the body there, in the box around a person.</summary>
    public static IReadOnlyList<double> Radii { get; } = [.. Sizes.Select(size => size.Radius)];

    /// <summary>
    /// Greatest depth of a joint below the surface of the part of the body that it belongs to, in any direction. What is met farther in
    /// front of the joint is another part of the body.
    /// </summary>
    public static IReadOnlyList<double> Depths { get; } = [.. Sizes.Select(size => size.Depth)];

    private static (double Radius, double Depth) SizeOf(Joint joint) =>
        joint switch
        {
            // The crown is on the surface, under the hair.
            Joint.HeadTop => (0.03, 0.12),

            // A head is 0.20 m long and 0.15 m wide; chin and neck are not in the way of the crown's box.
            Joint.HeadCenter => (0.09, 0.15),
            Joint.Neck => (0.08, 0.12),

            // Seen from the side, the shoulder is in front of the inner end of the collarbone, which is in the middle of the chest.
            Joint.RightClavicle or Joint.LeftClavicle => (0.06, 0.2),
            Joint.RightShoulder or Joint.LeftShoulder => (0.06, 0.14),
            Joint.RightElbow or Joint.LeftElbow => (0.05, 0.08),

            // The box has to reach the knuckles; along a forearm that points at the camera, the surface is farther than across it.
            Joint.RightWrist or Joint.LeftWrist => (0.09, 0.09),

            // A trunk is 0.35 m wide: seen from the side, its middle is half as deep.
            Joint.Spine0 or Joint.Spine1 or Joint.Spine2 or Joint.Spine3 or Joint.Spine4 => (0.12, 0.22),
            Joint.RightHip or Joint.LeftHip => (0.1, 0.16),
            Joint.RightKnee or Joint.LeftKnee => (0.07, 0.11),

            // The box has to reach the sole and most of the foot.
            _ => (0.1, 0.1),
        };
}
