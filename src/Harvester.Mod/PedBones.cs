using GTA.Math;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>Reads the joints of peds from the bones of their models.</summary>
internal sealed class PedBones
{
    /// <summary>Bones read in one step of a reading: under 3.6.0 a native takes about 19 microseconds.</summary>
    private const int BonesOfAStep = 7;

    /// <summary>
    /// The ids of the bones in the order of <see cref="Joint"/>, from the API's enumeration of bones: SKEL_Head, SKEL_Neck_1, and of each
    /// side clavicle, upper arm, forearm and hand; SKEL_Spine3 down to SKEL_Spine0 and SKEL_Spine_Root; thigh, calf and foot. The crown has
    /// no bone: 0.
    /// </summary>
    private static readonly int[] Ids =
    [
        0,
        0x796E,
        0x9995,
        0x29D2,
        0x9D4D,
        0x6E5C,
        0xDEAD,
        0xFCD9,
        0xB1C5,
        0xEEEB,
        0x49D9,
        0x60F2,
        0x60F1,
        0x60F0,
        0x5C01,
        0xE0FD,
        0xCA72,
        0x9000,
        0xCC4D,
        0xE39F,
        0xF9BB,
        0x3779,
    ];

    /// <summary>The ends of the body, which an animation that goes on moves first.</summary>
    private static readonly Joint[] Ends = [Joint.HeadCenter, Joint.RightWrist, Joint.LeftWrist, Joint.RightAnkle, Joint.LeftAnkle];

    private readonly Dictionary<int, bool> _hasAll = [];

    /// <summary>
    /// Whether the model of a ped has all bones, asked once for each model: what the game answers for a bone that is missing is not
    /// documented.
    /// </summary>
    public bool HasAll(int ped)
    {
        int model = Natives.EntityModel(ped);
        if (!_hasAll.TryGetValue(model, out bool hasAll))
        {
            _hasAll[model] = hasAll = Array.TrueForAll(Ids, id => id == 0 || Natives.Call<int>(Hash.GET_PED_BONE_INDEX, ped, id) >= 0);
        }

        return hasAll;
    }

    /// <summary>Reads the joints in steps.</summary>
    /// <param name="ped">A ped whose model has all bones.</param>
    /// <param name="known">Its joints as they were, which are returned if head, hands and feet have not moved; null to read all.</param>
    /// <param name="read">Receives the joints.</param>
    public static IEnumerable<WorkStep> ReadInSteps(int ped, Skeleton? known, WorkResult<Skeleton> read)
    {
        if (known is not null && Array.TrueForAll(Ends, joint => Read(ped, (int)joint) == known.Joints[(int)joint]))
        {
            read.Value = known;
            yield break;
        }

        var joints = new Vector3D[Skeleton.Count];
        for (int joint = 1; joint < joints.Length; joint++)
        {
            joints[joint] = Read(ped, joint);
            if (joint % BonesOfAStep == 0)
            {
                yield return WorkStep.Pause;
            }
        }

        joints[(int)Joint.HeadTop] = Skeleton.CrownOf(joints[(int)Joint.Neck], joints[(int)Joint.HeadCenter]);
        read.Value = new Skeleton(joints);
    }

    private static Vector3D Read(int ped, int joint) =>
        Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_PED_BONE_COORDS, ped, Ids[joint], 0f, 0f, 0f));
}
