using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Models that only scenarios have: things of road works, lost load, animals and a child. Animals have the class other.</summary>
internal static class ThingModels
{
    private static readonly Dictionary<string, string> Names = new(StringComparer.Ordinal)
    {
        ["cone"] = "prop_roadcone02a",
        ["barrier"] = "prop_barrier_work05",
        ["crate"] = "prop_box_wood05a",
        ["dog"] = "a_c_retriever",
        ["deer"] = "a_c_deer",
        ["cow"] = "a_c_cow",
        ["child"] = Child,
    };

    /// <summary>The game has no children; here one is 1.3 m high.</summary>
    private const string Child = "child";

    private static readonly Rgb Orange = new(226, 92, 30);
    private static readonly Rgb White = new(226, 226, 222);
    private static readonly Rgb Red = new(196, 40, 34);
    private static readonly Rgb Steel = new(140, 144, 148);
    private static readonly Rgb Wood = new(164, 124, 78);
    private static readonly Rgb DarkWood = new(122, 88, 52);
    private static readonly Rgb Black = new(34, 30, 30);

    /// <summary>The short names of the things.</summary>
    public static IEnumerable<string> ShortNames => Names.Keys;

    /// <summary>The model that a name, short or whole, stands for; null for none of these.</summary>
    public static string? NameOf(string name) =>
        Names.TryGetValue(name, out string? whole) ? whole
        : Names.ContainsValue(name) ? name
        : null;

    /// <summary>All of these models; they stand on their origins.</summary>
    public static IEnumerable<Model> All()
    {
        yield return Cone();
        yield return Barrier();
        yield return Crate();
        yield return Animal(Names["dog"], 0.6, 0.28, 0.62, new Rgb(186, 140, 84), horns: false);
        yield return Animal(Names["deer"], 1.3, 0.42, 1.35, new Rgb(140, 100, 66), horns: true);
        yield return Animal(Names["cow"], 2.0, 0.72, 1.5, new Rgb(92, 62, 44), horns: true);
        yield return PedestrianModels.Build(
            new Person(
                Child,
                1.3,
                0.75,
                0.78,
                1.3,
                Outfit.Shorts,
                false,
                false,
                new(226, 182, 150),
                new(84, 56, 36),
                new(214, 60, 54),
                new(50, 70, 130),
                Black
            )
        );
    }

    private static Model Cone()
    {
        var builder = new MeshBuilder { Kind = SurfaceKind.Thing };
        builder.AddBox(new(-0.2, -0.2, 0), new(0.2, 0.2, 0.04), Black);
        builder.AddCylinder(new(0, 0, 0.04), new(0, 0, 0.3), 0.15, 0.1, 10, Orange);
        builder.AddCylinder(new(0, 0, 0.3), new(0, 0, 0.48), 0.1, 0.065, 10, White);
        builder.AddCylinder(new(0, 0, 0.48), new(0, 0, 0.72), 0.065, 0.025, 10, Orange);
        return Model.Of(Names["cone"], ObjectClass.Other, [builder.Build()]);
    }

    private static Model Barrier()
    {
        const double half = 0.9;
        const int stripes = 6;
        var builder = new MeshBuilder { Kind = SurfaceKind.Thing };
        foreach (double side in new[] { -0.75, 0.75 })
        {
            builder.AddBox(new(side - 0.03, -0.3, 0), new(side + 0.03, 0.3, 0.05), Steel);
            builder.AddBox(new(side - 0.03, -0.03, 0.05), new(side + 0.03, 0.03, 1), Steel);
        }

        for (int i = 0; i < stripes; i++)
        {
            double from = -half + (2 * half * i / stripes);
            builder.AddBox(new(from, -0.05, 0.7), new(from + (2 * half / stripes), 0.05, 0.98), i % 2 == 0 ? Red : White);
        }

        return Model.Of(Names["barrier"], ObjectClass.Other, [builder.Build()]);
    }

    private static Model Crate()
    {
        var builder = new MeshBuilder { Kind = SurfaceKind.Thing };
        builder.AddBox(new(-0.45, -0.45, 0), new(0.45, 0.45, 0.8), Wood);
        foreach (double height in new[] { 0.0, 0.36, 0.72 })
        {
            builder.AddBox(new(-0.48, -0.48, height), new(0.48, 0.48, height + 0.08), DarkWood);
        }

        return Model.Of(Names["crate"], ObjectClass.Other, [builder.Build()]);
    }

    /// <summary>A four-legged animal that looks along +y.</summary>
    private static Model Animal(string name, double length, double width, double height, Rgb coat, bool horns)
    {
        var builder = new MeshBuilder { Kind = SurfaceKind.Thing };
        double back = height * 0.72;
        double thick = height * 0.2;
        double leg = back - thick;
        builder.AddEllipsoid(new(0, 0, back - (thick * 0.4)), new(width / 2, length / 2, thick), 10, 7, coat);
        foreach ((double x, double y) in new[] { (-1.0, -0.72), (1.0, -0.72), (-1.0, 0.66), (1.0, 0.66) })
        {
            var hip = new Vector3D(x * width * 0.3, y * length / 2, leg + 0.05);
            builder.AddCylinder(hip with { Z = 0 }, hip, width * 0.09, width * 0.14, 6, coat.Scaled(0.8));
        }

        var neck = new Vector3D(0, length * 0.4, back);
        var head = new Vector3D(0, length * 0.56, height * 0.94);
        builder.AddCylinder(neck, head, width * 0.24, width * 0.16, 7, coat);
        builder.AddEllipsoid(
            head + new Vector3D(0, length * 0.06, 0),
            new(width * 0.16, length * 0.12, height * 0.07),
            8,
            6,
            coat.Scaled(0.9)
        );
        if (horns)
        {
            foreach (int side in new[] { -1, 1 })
            {
                Vector3D root = head + new Vector3D(side * width * 0.1, 0, height * 0.05);
                builder.AddCylinder(root, root + new Vector3D(side * width * 0.25, 0, height * 0.14), 0.03, 0.01, 5, White);
            }
        }

        builder.AddCylinder(
            new(0, -length * 0.48, back),
            new(0, -length * 0.56, back * 0.65),
            width * 0.06,
            width * 0.03,
            5,
            coat.Scaled(0.7)
        );
        return Model.Of(name, ObjectClass.Other, [builder.Build()]);
    }
}
