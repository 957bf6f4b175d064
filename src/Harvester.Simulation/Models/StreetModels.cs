using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Street lamps, benches and trees, which are no entities. Their foot is the origin.</summary>
internal static class StreetModels
{
    /// <summary>Position of the lamp of a street lamp, in its model's frame.</summary>
    public static readonly Vector3D LampHead = new(-2.2, 0, 8.05);

    /// <summary>Depth of a bench with its back, metres.</summary>
    public const double BenchDepth = 0.6;

    private static readonly Rgb Pole = new(104, 108, 110);
    private static readonly Rgb Bark = new(92, 70, 50);
    private static readonly Rgb PalmBark = new(138, 116, 88);
    private static readonly Rgb Leaf = new(62, 98, 42);

    public static Model StreetLamp()
    {
        var builder = new MeshBuilder { Kind = SurfaceKind.Pole };
        builder.AddCylinder(new(0, 0, 0), new(0, 0, 7.6), 0.12, 0.07, 8, Pole);
        builder.AddCylinder(new(0, 0, 7.5), new(-2, 0, 8.2), 0.06, 0.04, 6, Pole);
        builder.AddBox(new(-2.6, -0.14, 8.12), new(-1.8, 0.14, 8.26), Pole);
        builder.AddBox(new(-2.55, -0.12, 8.06), new(-1.9, 0.12, 8.12), new(255, 224, 168), Surface.NightLamp);
        return Model.Of("prop_streetlight_01", ObjectClass.Other, [builder.Build()]);
    }

    /// <summary>A bench whose seat's middle is above the origin; who sits on it looks along +y.</summary>
    public static Model Bench()
    {
        const double seat = Rest.SeatHeight;
        const double half = 0.85;
        var builder = new MeshBuilder { Kind = SurfaceKind.Thing };
        builder.AddBox(new(-half, -0.2, seat - 0.06), new(half, 0.26, seat), Bark);
        builder.AddBox(new(-half, -0.3, seat + 0.12), new(half, -0.26, seat + 0.4), Bark);
        foreach (double side in new[] { -0.7, 0.7 })
        {
            builder.AddBox(new(side - 0.03, -0.26, 0), new(side + 0.03, 0.22, seat - 0.06), Pole);
            builder.AddBox(new(side - 0.03, -0.27, seat - 0.06), new(side + 0.03, -0.22, seat + 0.36), Pole);
        }

        return Model.Of("prop_bench_01a", ObjectClass.Other, [builder.Build()]);
    }

    public static IEnumerable<Model> Trees()
    {
        yield return Model.Of("prop_tree_oak_01", ObjectClass.Other, [Broadleaf(3, 7.5), Broadleaf(4, 6.2), Broadleaf(5, 8.8)]);
        yield return Model.Of("prop_tree_cypress_01", ObjectClass.Other, [Cypress(9), Cypress(7)]);
        yield return Model.Of("prop_palm_huge_01a", ObjectClass.Other, [Palm(6, 12.5), Palm(7, 10.5), Palm(8, 14)]);
    }

    private static Mesh Broadleaf(int seed, double height)
    {
        var random = new Random(seed);
        var builder = new MeshBuilder { Kind = SurfaceKind.Vegetation };
        builder.AddCylinder(new(0, 0, 0), new(0, 0, height * 0.55), 0.22, 0.12, 7, Bark);
        for (int cloud = 0; cloud < 6; cloud++)
        {
            double turn = cloud * 2.4;
            double away = cloud == 0 ? 0 : height * 0.16;
            var centre = new Vector3D(Math.Cos(turn) * away, Math.Sin(turn) * away, height * (0.58 + (0.045 * cloud)));
            double size = height * (0.17 + (random.NextDouble() * 0.06));
            builder.AddEllipsoid(centre, new(size, size, size * 0.85), 9, 6, Leaf.Scaled(0.85 + (random.NextDouble() * 0.35)));
        }

        return builder.Build();
    }

    private static Mesh Cypress(double height)
    {
        var builder = new MeshBuilder { Kind = SurfaceKind.Vegetation };
        builder.AddCylinder(new(0, 0, 0), new(0, 0, height * 0.15), 0.16, 0.14, 6, Bark);
        builder.AddEllipsoid(new(0, 0, height * 0.54), new(height * 0.11, height * 0.11, height * 0.46), 10, 9, Leaf.Scaled(0.72));
        return builder.Build();
    }

    private static Mesh Palm(int seed, double height)
    {
        const int fronds = 13;
        var random = new Random(seed);
        var builder = new MeshBuilder { Kind = SurfaceKind.Vegetation };
        builder.AddCylinder(new(0, 0, 0), new(0, 0, height), 0.24, 0.13, 8, PalmBark);
        var crown = new Vector3D(0, 0, height);
        for (int frond = 0; frond < fronds; frond++)
        {
            double turn = frond * 2.4;
            double reach = 1.9 + (random.NextDouble() * 0.5);
            double lift = 0.9 - (1.5 * frond / fronds);
            var along = new Vector3D(Math.Cos(turn), Math.Sin(turn), 0);
            var across = new Vector3D(-Math.Sin(turn) * 0.32, Math.Cos(turn) * 0.32, 0);
            Vector3D bend = crown + (along * (reach * 0.55)) + new Vector3D(0, 0, lift);
            Vector3D tip = crown + (along * reach) + new Vector3D(0, 0, lift - 0.9);
            Rgb green = new Rgb(84, 116, 50).Scaled(0.8 + (random.NextDouble() * 0.4));
            builder.AddTriangle(crown, bend - across, bend + across, green);
            builder.AddTriangle(bend - across, bend + across, tip, green);
        }

        return builder.Build();
    }
}
