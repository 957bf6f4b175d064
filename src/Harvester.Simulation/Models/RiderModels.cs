using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// The riders of two-wheelers, in the frame of their machine: astride the saddle, hands on the handlebar and feet on the pegs or pedals.
/// </summary>
internal static class RiderModels
{
    private const double Shin = 0.46;
    private const double HelmetHeight = 0.14;

    /// <summary>Depth of the crown below the top of the helmet, metres.</summary>
    private const double CrownDepth = 0.02;
    private static readonly Rgb Skin = new(206, 160, 126);
    private static readonly Rgb Shoes = new(36, 32, 32);

    private static readonly (Rgb Jacket, Rgb Trousers, Rgb Helmet)[] Clothes =
    [
        (new(40, 42, 48), new(44, 48, 60), new(200, 40, 40)),
        (new(150, 40, 36), new(36, 38, 44), new(230, 230, 226)),
        (new(60, 90, 150), new(70, 72, 78), new(34, 34, 38)),
        (new(214, 190, 60), new(50, 54, 66), new(210, 210, 214)),
    ];

    /// <summary>The riders of a machine, one for each set of clothes.</summary>
    public static IReadOnlyList<Model> Of(VehicleRow row) => [.. Clothes.Select((clothes, number) => Build(row, number, clothes))];

    private static Model Build(VehicleRow row, int number, (Rgb Jacket, Rgb Trousers, Rgb Helmet) clothes)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder { Kind = SurfaceKind.Person };
        (double seat, double saddle, double lean, double hands, double grips) = row.Shape switch
        {
            VehicleShape.Bicycle => (0.36, 0.87, 0.3, 0.705, 0.98),
            VehicleShape.Chopper => (0.32, 0.58, 0.06, 0.66, 0.94),
            _ => (0.34, 0.75, 0.34, 0.68, 0.82),
        };
        Vector3D hips = frame.At(0.5, seat, saddle) + new Vector3D(0, 0, 0.08);
        Vector3D neck = hips + new Vector3D(0, lean, row.Shape == VehicleShape.Chopper ? 0.54 : 0.46);
        AddTrunk(builder, hips, neck, clothes.Jacket);
        Vector3D head = neck + new Vector3D(0, 0.05 + (lean * 0.1), 0.17);
        builder.AddEllipsoid(head, new(0.12, 0.14, HelmetHeight), 10, 7, clothes.Helmet, Surface.Paint);
        if (row.Shape == VehicleShape.Bicycle)
        {
            builder.AddEllipsoid(head + new Vector3D(0, 0.035, -0.05), new(0.085, 0.12, 0.12), 8, 6, Skin);
        }

        var joints = new Vector3D[Skeleton.Count];
        AddTrunkJoints(joints, hips, neck, head);
        foreach (int side in new[] { -1, 1 })
        {
            AddArm(builder, joints, neck, frame.At(0.5 + (side * 0.42), hands, grips), side, clothes.Jacket);
            AddLeg(builder, joints, hips, FootAt(row.Shape, frame, side), side, clothes.Trousers);
        }

        string kind = row.Shape == VehicleShape.Bicycle ? "a_m_y_roadcyc" : "a_m_y_motox";
        return Model.Of($"{kind}_{number + 1:00}", ObjectClass.Rider, [builder.Build()]) with { Skeletons = [new Skeleton(joints)] };
    }

    /// <summary>Crown, head, neck, and the spine, whose joints divide the line from the hips to the neck equally.</summary>
    private static void AddTrunkJoints(Vector3D[] joints, Vector3D hips, Vector3D neck, Vector3D head)
    {
        const int spine = Joint.Spine4 - Joint.Spine0 + 1;
        joints[(int)Joint.HeadTop] = head + new Vector3D(0, 0, HelmetHeight - CrownDepth);
        joints[(int)Joint.HeadCenter] = head;
        joints[(int)Joint.Neck] = neck;
        for (int i = 0; i < spine; i++)
        {
            joints[(int)Joint.Spine0 + i] = hips + ((neck - hips) * ((double)i / spine));
        }
    }

    /// <summary>The pedals of a bicycle stand upright, so one foot is low and the other high.</summary>
    private static Vector3D FootAt(VehicleShape shape, ModelFrame frame, int side) =>
        shape switch
        {
            VehicleShape.Bicycle => frame.At(0.5, 0.46, 0.3) + new Vector3D(side * 0.13, 0.02, side * 0.16),
            VehicleShape.Chopper => frame.At(0.5, 0.66, 0.22) + new Vector3D(side * 0.24, 0, 0),
            _ => frame.At(0.5, 0.36, 0.32) + new Vector3D(side * 0.2, 0, 0),
        };

    private static void AddTrunk(MeshBuilder builder, Vector3D hips, Vector3D neck, Rgb jacket)
    {
        Vector3D shoulders = hips + ((neck - hips) * 0.92);
        builder.AddCylinder(hips + new Vector3D(0, -0.02, -0.05), hips + ((neck - hips) * 0.5), 0.15, 0.15, 8, jacket);
        builder.AddCylinder(hips + ((neck - hips) * 0.5), shoulders, 0.15, 0.19, 8, jacket);
        builder.AddCylinder(shoulders - new Vector3D(0.22, 0, 0.03), shoulders + new Vector3D(0.22, 0, -0.03), 0.075, 0.075, 6, jacket);
        builder.AddCylinder(shoulders, neck + new Vector3D(0, 0.03, 0.08), 0.06, 0.055, 6, Skin);
    }

    private static void AddArm(MeshBuilder builder, Vector3D[] joints, Vector3D neck, Vector3D grip, int side, Rgb jacket)
    {
        Vector3D shoulder = neck + new Vector3D(side * 0.21, -0.02, -0.06);
        Vector3D elbow = ((shoulder + grip) * 0.5) + new Vector3D(side * 0.06, -0.05, -0.06);
        Joint first = side < 0 ? Joint.LeftClavicle : Joint.RightClavicle;
        joints[(int)first] = neck + ((shoulder - neck) * 0.4);
        joints[(int)first + 1] = shoulder;
        joints[(int)first + 2] = elbow;
        joints[(int)first + 3] = grip;
        builder.AddCylinder(shoulder, elbow, 0.06, 0.05, 6, jacket);
        builder.AddCylinder(elbow, grip, 0.05, 0.04, 6, jacket);
        builder.AddEllipsoid(grip, new(0.05, 0.06, 0.05), 6, 4, Shoes);
    }

    private static void AddLeg(MeshBuilder builder, Vector3D[] joints, Vector3D hips, Vector3D foot, int side, Rgb trousers)
    {
        // The knee lies ahead of the line from hip to foot, by Pythagoras about as far as a shin of this length bends it.
        Vector3D hip = hips + new Vector3D(side * 0.11, 0, -0.03);
        Vector3D middle = (hip + foot) * 0.5;
        double half = (hip - foot).Length / 2;
        double bend = half < Shin ? Math.Sqrt((Shin * Shin) - (half * half)) : 0;
        Vector3D along = (foot - hip).Normalized();
        Vector3D ahead = new Vector3D(0, 1, 0) - (along * along.Y);
        Vector3D knee = middle + (ahead.Normalized() * bend) + new Vector3D(side * 0.05, 0, 0);
        Joint first = side < 0 ? Joint.LeftHip : Joint.RightHip;
        joints[(int)first] = hip;
        joints[(int)first + 1] = knee;
        joints[(int)first + 2] = foot + new Vector3D(0, -0.03, 0.06);
        builder.AddCylinder(hip, knee, 0.1, 0.075, 7, trousers);
        builder.AddCylinder(knee, foot + new Vector3D(0, -0.03, 0.06), 0.07, 0.05, 7, trousers);
        builder.AddBox(foot + new Vector3D(-0.045, -0.1, -0.02), foot + new Vector3D(0.045, 0.16, 0.07), Shoes);
    }
}
