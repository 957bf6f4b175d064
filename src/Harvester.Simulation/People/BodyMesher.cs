using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.People;

/// <summary>
/// Makes the mesh of a body around its joints. Rings are given by fractions of the body's height; those of the trunk are scaled by the
/// girth, and those of limbs by its square root, so that a limb's cross section grows in proportion to the girth.
/// </summary>
/// <param name="person">Build and clothes.</param>
/// <param name="pose">The joints.</param>
/// <param name="builderOf">The mesh that a part is added to; the same for all, unless parts must be distinguishable.</param>
internal sealed class BodyMesher(Person person, BodyPose pose, Func<BodyPart, MeshBuilder> builderOf)
{
    private const int LimbSides = 7;
    private const int TrunkSides = 10;

    private readonly double _height = person.Height;
    private readonly Skeleton _joints = pose.Skeleton;

    /// <summary>The mesh of a person in a posture.</summary>
    public static Mesh MeshOf(Person person, BodyPose pose)
    {
        var builder = new MeshBuilder();
        new BodyMesher(person, pose, _ => builder).AddAll();
        return builder.Build();
    }

    /// <summary>Adds all parts.</summary>
    public void AddAll()
    {
        AddTrunk();
        AddHead();
        AddArm(Joint.RightShoulder, pose.Right, BodyPart.RightUpperArm);
        AddArm(Joint.LeftShoulder, pose.Left, BodyPart.LeftUpperArm);
        AddLeg(Joint.RightHip, pose.Right, BodyPart.RightThigh);
        AddLeg(Joint.LeftHip, pose.Left, BodyPart.LeftThigh);
        if (person.Outfit is Outfit.Skirt or Outfit.Coat)
        {
            AddSkirt();
        }
    }

    private void AddTrunk()
    {
        // The trunk grows with the girth g: half widths as (1 + g) / 2, half depths as g.
        double wide = 0.5 * _height * (1 + person.Girth);
        double deep = _height * person.Girth;
        Vector3D hips = (_joints[Joint.RightHip] + _joints[Joint.LeftHip]) * 0.5;
        Vector3D shoulders = (_joints[Joint.RightShoulder] + _joints[Joint.LeftShoulder]) * 0.5;
        Vector3D up = (shoulders - hips).Normalized();
        var across = new Vector3D(1, 0, 0);
        double chest = 0.105 * wide * person.Shoulders;
        Rgb low = person.Outfit == Outfit.Coat ? person.Top : person.Bottom;
        Loft pelvis = new(TrunkSides);
        pelvis.Add(hips - (up * (0.035 * _height)), across * (0.075 * wide), up.Cross(across) * (0.055 * deep));
        pelvis.Add(_joints[Joint.Spine4], across * (0.098 * wide), up.Cross(across) * (0.066 * deep));
        pelvis.Add(_joints[Joint.Spine3] + (up * (0.012 * _height)), across * (0.088 * wide), up.Cross(across) * (0.06 * deep));
        pelvis.AddTo(builderOf(BodyPart.Torso), low);
        Loft trunk = new(TrunkSides);
        trunk.Add(_joints[Joint.Spine3], across * (0.09 * wide), up.Cross(across) * (0.062 * deep));
        trunk.Add(_joints[Joint.Spine1], pose.ChestRight * (0.092 * wide), pose.ChestForward * (0.064 * deep));
        trunk.Add(_joints[Joint.Spine0], pose.ChestRight * chest, pose.ChestForward * (0.068 * deep));
        trunk.Add(shoulders, pose.ChestRight * (0.112 * _height * person.Shoulders), pose.ChestForward * (0.05 * deep));
        trunk.Add(shoulders + (up * (0.032 * _height)), pose.ChestRight * (0.045 * _height), pose.ChestForward * (0.04 * _height));
        trunk.AddTo(builderOf(BodyPart.Torso), person.Top);
    }

    private void AddHead()
    {
        MeshBuilder builder = builderOf(BodyPart.Head);
        Vector3D head = _joints[Joint.HeadCenter];
        Vector3D up = (_joints[Joint.HeadTop] - head).Normalized();
        Vector3D face = pose.FaceForward;
        Vector3D right = pose.ChestRight;
        double size = _height;
        Loft neck = new(LimbSides);
        neck.Add(_joints[Joint.Neck] - (up * (0.015 * size)), right * (0.034 * size), face * (0.034 * size));
        neck.Add(head - (up * (0.03 * size)), right * (0.031 * size), face * (0.033 * size));
        neck.AddTo(builder, person.Skin);
        Loft skull = new(8);
        skull.Add(head - (up * (0.064 * size)) + (face * (0.02 * size)), right * (0.018 * size), face * (0.022 * size));
        skull.Add(head - (up * (0.045 * size)) + (face * (0.01 * size)), right * (0.034 * size), face * (0.046 * size));
        skull.Add(head, right * (0.043 * size), face * (0.055 * size));
        skull.Add(head + (up * (0.035 * size)), right * (0.041 * size), face * (0.052 * size));
        skull.Add(head + (up * (0.06 * size)), right * (0.026 * size), face * (0.032 * size));
        skull.AddTo(builder, person.Skin);
        double down = person.HasLongHair ? 0.085 : 0.02;
        Loft hair = new(8);
        hair.Add(head - (up * (down * size)) - (face * (0.022 * size)), right * (0.042 * size), face * (0.034 * size));
        hair.Add(head + (up * (0.015 * size)) - (face * (0.012 * size)), right * (0.047 * size), face * (0.049 * size));
        hair.Add(head + (up * (0.045 * size)) - (face * (0.004 * size)), right * (0.042 * size), face * (0.054 * size));
        hair.Add(head + (up * (0.07 * size)), right * (0.018 * size), face * (0.026 * size));
        hair.AddTo(builder, person.Hair);
        builder.AddTriangle(
            head + (face * (0.072 * size)) - (up * (0.008 * size)),
            head + (face * (0.052 * size)) + (right * (0.008 * size)),
            head + (face * (0.052 * size)) + (up * (0.014 * size)) - (right * (0.008 * size)),
            person.Skin
        );
    }

    private void AddArm(Joint first, LimbEnds ends, BodyPart part)
    {
        Vector3D shoulder = _joints[first];
        Vector3D elbow = _joints[first + 1];
        Vector3D wrist = _joints[first + 2];
        double thick = _height * Math.Sqrt(person.Girth);
        Vector3D outward = (shoulder - _joints[Joint.Spine0]).Normalized();
        Limb upper = new(LimbSides, pose.ChestRight);
        upper.Add(shoulder + ((shoulder - elbow).Normalized() * (0.018 * thick)) - (outward * (0.006 * thick)), 0.018 * thick);
        upper.Add(shoulder, 0.032 * thick);
        upper.Add(elbow, 0.024 * thick);
        upper.AddTo(builderOf(part), person.Top);
        Limb lower = new(LimbSides, pose.ChestRight);
        lower.Add(elbow, 0.025 * thick);
        lower.Add(elbow + ((wrist - elbow) * 0.3), 0.024 * thick);
        lower.Add(wrist, 0.017 * thick);
        lower.AddTo(builderOf(part + 1), person.HasSleeves ? person.Top : person.Skin);
        Limb hand = new(6, pose.ChestRight);
        hand.Add(wrist, 0.015 * _height);
        hand.Add(wrist + ((ends.FingerTips - wrist) * 0.5), 0.022 * _height);
        hand.Add(ends.FingerTips, 0.008 * _height);
        hand.AddTo(builderOf(part + 1), person.Skin);
    }

    private void AddLeg(Joint first, LimbEnds ends, BodyPart part)
    {
        Vector3D hip = _joints[first];
        Vector3D knee = _joints[first + 1];
        Vector3D ankle = _joints[first + 2];
        double thick = _height * Math.Sqrt(person.Girth);
        bool areShanksBare = person.Outfit is Outfit.Shorts or Outfit.Skirt;
        Limb thigh = new(8, new Vector3D(1, 0, 0));
        thigh.Add(hip + ((hip - knee).Normalized() * (0.02 * _height)), 0.03 * thick);
        thigh.Add(hip, 0.049 * thick);
        thigh.Add(knee, 0.034 * thick);
        thigh.AddTo(builderOf(part), person.Bottom);
        Limb shank = new(LimbSides, new Vector3D(1, 0, 0));
        shank.Add(knee - ((ankle - knee).Normalized() * (0.01 * _height)), 0.032 * thick);
        shank.Add(knee + ((ankle - knee) * 0.3), 0.034 * thick);
        shank.Add(ankle, (areShanksBare ? 0.022 : 0.028) * thick);
        shank.AddTo(builderOf(part + 1), areShanksBare ? person.Skin : person.Bottom);
        AddFoot(ankle, knee, ends.FootForward, builderOf(part + 1));
    }

    private void AddFoot(Vector3D ankle, Vector3D knee, Vector3D forward, MeshBuilder builder)
    {
        Proportions sizes = new(_height, person.Shoulders);
        var right = new Vector3D(1, 0, 0);
        Vector3D up = right.Cross(forward);
        double half = sizes.Ankle / 2;
        Vector3D middle = ankle - (up * half);
        Loft foot = new(6);
        foot.Add(middle - (forward * sizes.AnkleToHeel), right * (0.018 * _height), up * half);
        foot.Add(middle, right * (0.023 * _height), up * half);
        foot.Add(middle + (forward * sizes.AnkleToBall) - (up * (half * 0.3)), right * (0.027 * _height), up * (half * 0.7));
        foot.Add(middle + (forward * sizes.AnkleToToe) - (up * (half * 0.5)), right * (0.015 * _height), up * (half * 0.4));
        foot.AddTo(builder, person.Shoes);
        Limb shaft = new(6, right);
        shaft.Add(ankle + ((knee - ankle).Normalized() * (0.02 * _height)), 0.024 * _height);
        shaft.Add(ankle - (up * half), 0.024 * _height);
        shaft.AddTo(builder, person.Shoes);
    }

    /// <summary>A skirt or the lower part of a coat, wide enough for the legs in it.</summary>
    private void AddSkirt()
    {
        Vector3D hips = (_joints[Joint.RightHip] + _joints[Joint.LeftHip]) * 0.5;
        Vector3D knees = (_joints[Joint.RightKnee] + _joints[Joint.LeftKnee]) * 0.5;
        Vector3D hem = hips + ((knees - hips) * 0.9);
        Vector3D along = (hem - hips).Normalized();
        var right = new Vector3D(1, 0, 0);
        Vector3D depth = right.Cross(along);
        Vector3D apart = _joints[Joint.RightKnee] - _joints[Joint.LeftKnee];
        double wide = 0.5 * _height * (1 + person.Girth);
        double reach = (0.45 * Math.Abs(apart.Dot(depth))) + (0.045 * _height);
        Loft skirt = new(TrunkSides);
        skirt.Add(_joints[Joint.Spine4], right * (0.1 * wide), depth * (0.068 * _height * person.Girth));
        skirt.Add(hem, right * ((0.5 * Math.Abs(apart.X)) + (0.05 * wide)), depth * reach);
        skirt.AddTo(builderOf(BodyPart.Torso), person.Outfit == Outfit.Coat ? person.Top : person.Bottom);
    }
}
