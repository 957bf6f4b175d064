using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Rocks and bushes of open land, which are no entities. Their foot is the origin.</summary>
internal static class RockModels
{
    private static readonly Rgb Stone = new(138, 124, 106);
    private static readonly Rgb Leaf = new(92, 106, 56);

    /// <summary>Rocks of several sizes.</summary>
    public static Model Rock { get; } = Model.Of("prop_rock_1_a", ObjectClass.Other, [Boulder(1, 0.5), Boulder(2, 0.9), Boulder(3, 1.6)]);

    /// <summary>Bushes of several sizes.</summary>
    public static Model Bush { get; } = Model.Of("prop_bush_lrg_01", ObjectClass.Other, [Shrub(4, 0.7), Shrub(5, 1.1)]);

    private static Mesh Boulder(int seed, double size)
    {
        Random random = new(seed);
        MeshBuilder builder = new() { Kind = SurfaceKind.Terrain };
        const int sides = 7;
        Vector3D[] low = new Vector3D[sides];
        Vector3D[] high = new Vector3D[sides];
        for (int i = 0; i < sides; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
            double wide = size * (0.8 + (0.5 * random.NextDouble()));
            low[i] = new Vector3D(cos * wide, sin * wide, -0.5);
            high[i] = new Vector3D(cos * wide * 0.6, sin * wide * 0.6, size * (0.5 + (0.3 * random.NextDouble())));
        }

        Vector3D top = new(0, 0, size * 0.85);
        for (int i = 0; i < sides; i++)
        {
            int next = (i + 1) % sides;
            Rgb colour = Stone.Scaled(0.85 + (0.25 * random.NextDouble()));
            builder.AddQuad(low[i], low[next], high[next], high[i], colour);
            builder.AddTriangle(high[i], high[next], top, colour);
        }

        return builder.Build();
    }

    private static Mesh Shrub(int seed, double size)
    {
        Random random = new(seed);
        MeshBuilder builder = new() { Kind = SurfaceKind.Vegetation };
        const int clouds = 3;
        for (int i = 0; i < clouds; i++)
        {
            Vector3D centre = new(size * (random.NextDouble() - 0.5), size * (random.NextDouble() - 0.5), size * 0.4);
            builder.AddEllipsoid(
                centre,
                new Vector3D(size * 0.6, size * 0.6, size * 0.5),
                7,
                4,
                Leaf.Scaled(0.8 + (0.4 * random.NextDouble()))
            );
        }

        return builder.Build();
    }
}
