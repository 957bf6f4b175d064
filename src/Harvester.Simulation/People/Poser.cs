using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.People;

/// <summary>Places the joints of a body in a posture: trunk and arms from their angles, knees between hip and ankle.</summary>
/// <param name="sizes">The lengths of the limbs.</param>
internal sealed class Poser(Proportions sizes)
{
    /// <summary>Largest part of a leg's length that it is stretched to, so that a knee never snaps.</summary>
    private const double MaxStretch = 0.998;

    public BodyPose Pose(Posture posture)
    {
        double height = sizes.Height;
        var joints = new Vector3D[Skeleton.Count];
        var hips = new Vector3D(0, posture.HipForward, posture.HipHeight - sizes.HipHeight);
        var up = new Vector3D(0, Math.Sin(posture.Lean), Math.Cos(posture.Lean));
        var ahead = new Vector3D(0, Math.Cos(posture.Lean), -Math.Sin(posture.Lean));
        var right = new Vector3D(1, 0, 0);
        Vector3D chestRight = (right * Math.Cos(posture.Turn)) + (ahead * Math.Sin(posture.Turn));
        Vector3D chestForward = up.Cross(chestRight);

        // Fractions of the height above the hips, from the chest down to the pelvis.
        ReadOnlySpan<double> spine = [0.225, 0.165, 0.11, 0.06, 0.025];
        for (int i = 0; i < spine.Length; i++)
        {
            joints[(int)Joint.Spine0 + i] = hips + (up * (spine[i] * height));
        }

        Vector3D shoulders = hips + (up * (0.298 * height));
        Vector3D neck = hips + (up * (0.34 * height));
        Vector3D headUp = (up * Math.Cos(posture.Nod)) + (chestForward * Math.Sin(posture.Nod));
        Vector3D head = neck + (headUp * (0.07 * height));
        joints[(int)Joint.Neck] = neck;
        joints[(int)Joint.HeadCenter] = head;
        joints[(int)Joint.HeadTop] = Skeleton.CrownOf(neck, head);
        Vector3D collar = shoulders + (up * (0.012 * height)) + (chestForward * (0.02 * height));
        Vector3D aside = chestRight * (0.025 * height);
        joints[(int)Joint.RightClavicle] = collar + aside;
        joints[(int)Joint.LeftClavicle] = collar - aside;
        var chest = new Axis3(chestRight, chestForward, up);
        LimbEnds rightEnds = Place(joints, Side.Right, shoulders, hips, chest, posture.RightArm, posture.RightFoot);
        LimbEnds leftEnds = Place(joints, Side.Left, shoulders, hips, chest, posture.LeftArm, posture.LeftFoot);
        return new BodyPose(new Skeleton(joints), rightEnds, leftEnds, chestRight, chestForward, headUp.Cross(chestRight));
    }

    private LimbEnds Place(
        Vector3D[] joints,
        Side side,
        Vector3D shoulders,
        Vector3D hips,
        in Axis3 chest,
        ArmPosture arm,
        FootPosture foot
    )
    {
        Vector3D outward = chest.Right * side.Sign;
        Vector3D shoulder = shoulders + (outward * sizes.ShoulderAside);
        Vector3D hanging = (chest.Up * -Math.Cos(arm.Swing)) + (chest.Forward * Math.Sin(arm.Swing));
        Vector3D upperArm = (hanging * Math.Cos(arm.Aside)) + (outward * Math.Sin(arm.Aside));
        double lifted = arm.Swing + arm.Bend;
        Vector3D forward = (chest.Up * -Math.Cos(lifted)) + (chest.Forward * Math.Sin(lifted));
        double across = arm.Aside - arm.Inward;
        Vector3D forearm = (forward * Math.Cos(across)) + (outward * Math.Sin(across));
        Vector3D elbow = shoulder + (upperArm * sizes.UpperArm);
        Vector3D wrist = elbow + (forearm * sizes.Forearm);
        joints[side.Arm] = shoulder;
        joints[side.Arm + 1] = elbow;
        joints[side.Arm + 2] = wrist;

        Vector3D hip = hips + new Vector3D(side.Sign * sizes.HipAside, 0, 0);
        var ankle = new Vector3D(hip.X + (side.Sign * foot.Spread), foot.Forward, foot.Height - sizes.HipHeight);
        joints[side.Leg] = hip;
        joints[side.Leg + 1] = Knee(hip, ankle);
        joints[side.Leg + 2] = ankle;
        return new LimbEnds(wrist + (forearm * sizes.Hand), new Vector3D(0, Math.Cos(foot.Pitch), Math.Sin(foot.Pitch)));
    }

    /// <summary>The knee of a leg between two points: where spheres around both meet, in front of the line between them.</summary>
    private Vector3D Knee(Vector3D hip, Vector3D ankle)
    {
        Vector3D leg = ankle - hip;
        double length = Math.Min(leg.Length, MaxStretch * (sizes.Thigh + sizes.Shank));
        Vector3D along = leg.Normalized();
        double distance = ((length * length) + (sizes.Thigh * sizes.Thigh) - (sizes.Shank * sizes.Shank)) / (2 * length);
        double offset = Math.Sqrt(Math.Max(0, (sizes.Thigh * sizes.Thigh) - (distance * distance)));
        Vector3D bend = along.Cross(new Vector3D(-1, 0, 0)).Normalized();
        return hip + (along * distance) + (bend * offset);
    }

    private readonly record struct Axis3(Vector3D Right, Vector3D Forward, Vector3D Up);

    private readonly record struct Side(double Sign, int Arm, int Leg)
    {
        public static readonly Side Right = new(1, (int)Joint.RightShoulder, (int)Joint.RightHip);
        public static readonly Side Left = new(-1, (int)Joint.LeftShoulder, (int)Joint.LeftHip);
    }
}
