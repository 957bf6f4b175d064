using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>The bones of people by the API's names, with the ids that the API gives them, in decimal as there.</summary>
internal static class PedBoneIds
{
    private static readonly Dictionary<int, Joint> Joints = new()
    {
        [31086] = Joint.HeadCenter,
        [39317] = Joint.Neck,
        [10706] = Joint.RightClavicle,
        [40269] = Joint.RightShoulder,
        [28252] = Joint.RightElbow,
        [57005] = Joint.RightWrist,
        [64729] = Joint.LeftClavicle,
        [45509] = Joint.LeftShoulder,
        [61163] = Joint.LeftElbow,
        [18905] = Joint.LeftWrist,
        [24818] = Joint.Spine0,
        [24817] = Joint.Spine1,
        [24816] = Joint.Spine2,
        [23553] = Joint.Spine3,
        [57597] = Joint.Spine4,
        [51826] = Joint.RightHip,
        [36864] = Joint.RightKnee,
        [52301] = Joint.RightAnkle,
        [58271] = Joint.LeftHip,
        [63931] = Joint.LeftKnee,
        [14201] = Joint.LeftAnkle,
    };

    /// <summary>The joint of a bone; null for a bone that people do not have.</summary>
    public static Joint? JointOf(int bone) => Joints.TryGetValue(bone, out Joint joint) ? joint : null;
}
