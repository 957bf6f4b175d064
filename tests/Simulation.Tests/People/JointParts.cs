using Harvester.Sessions.Scenes;
using Harvester.Simulation.People;

namespace Harvester.Simulation.Tests.People;

/// <summary>Which parts of a drawn body a joint belongs to, by anatomy.</summary>
internal static class JointParts
{
    /// <summary>The parts whose surface shows a joint.</summary>
    public static IReadOnlyList<BodyPart> Of(Joint joint) =>
        joint switch
        {
            Joint.HeadTop or Joint.HeadCenter => [BodyPart.Head],
            Joint.Neck => [BodyPart.Head, BodyPart.Torso],
            Joint.RightShoulder => [BodyPart.RightUpperArm, BodyPart.Torso],
            Joint.LeftShoulder => [BodyPart.LeftUpperArm, BodyPart.Torso],
            Joint.RightElbow => [BodyPart.RightUpperArm, BodyPart.RightForearm],
            Joint.LeftElbow => [BodyPart.LeftUpperArm, BodyPart.LeftForearm],
            Joint.RightWrist => [BodyPart.RightForearm],
            Joint.LeftWrist => [BodyPart.LeftForearm],
            Joint.RightHip => [BodyPart.RightThigh, BodyPart.Torso],
            Joint.LeftHip => [BodyPart.LeftThigh, BodyPart.Torso],

            // A skirt belongs to the trunk and covers the knees.
            Joint.RightKnee => [BodyPart.RightThigh, BodyPart.RightShank, BodyPart.Torso],
            Joint.LeftKnee => [BodyPart.LeftThigh, BodyPart.LeftShank, BodyPart.Torso],
            Joint.RightAnkle => [BodyPart.RightShank],
            Joint.LeftAnkle => [BodyPart.LeftShank],
            _ => [BodyPart.Torso],
        };

    /// <summary>The same joint of the other side; null for those in the middle, with the inner ends of the collarbones.</summary>
    public static Joint? Other(Joint joint) =>
        joint switch
        {
            >= Joint.RightShoulder and <= Joint.RightWrist => joint + 4,
            >= Joint.LeftShoulder and <= Joint.LeftWrist => joint - 4,
            >= Joint.RightHip and <= Joint.RightAnkle => joint + 3,
            >= Joint.LeftHip => joint - 3,
            _ => null,
        };

    /// <summary>The joints that lie within a limb, at its ends.</summary>
    public static IReadOnlyList<Joint> LimbsOf(BodyPart part) =>
        part switch
        {
            BodyPart.Head => [Joint.HeadCenter],
            BodyPart.Torso => [Joint.Spine0, Joint.Spine1, Joint.Spine2, Joint.Spine3, Joint.Spine4],
            BodyPart.RightUpperArm => [Joint.RightShoulder, Joint.RightElbow],
            BodyPart.RightForearm => [Joint.RightElbow, Joint.RightWrist],
            BodyPart.LeftUpperArm => [Joint.LeftShoulder, Joint.LeftElbow],
            BodyPart.LeftForearm => [Joint.LeftElbow, Joint.LeftWrist],
            BodyPart.RightThigh => [Joint.RightHip, Joint.RightKnee],
            BodyPart.RightShank => [Joint.RightKnee, Joint.RightAnkle],
            BodyPart.LeftThigh => [Joint.LeftHip, Joint.LeftKnee],
            _ => [Joint.LeftKnee, Joint.LeftAnkle],
        };
}
