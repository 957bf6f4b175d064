using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Traffic signs by the game's names: a plate on a post whose foot is the origin; the face looks towards -y. The game's exact sizes are not
/// public; these follow real signs.
/// </summary>
internal static class SignModels
{
    private const double FaceY = -0.05;
    private const double PlateThickness = 0.012;
    private const double Ink = 0.001;
    private static readonly Rgb Red = new(178, 20, 28);
    private static readonly Rgb White = new(236, 236, 232);
    private static readonly Rgb Black = new(18, 18, 20);
    private static readonly Rgb Yellow = new(244, 190, 20);
    private static readonly Rgb Metal = new(132, 136, 138);

    public static IEnumerable<Model> All()
    {
        yield return Build("prop_sign_road_01a", Stop);
        yield return Build("prop_sign_road_02a", Yield);
        yield return Build("prop_sign_road_03a", DoNotEnter);
        yield return Build("prop_sign_road_03e", builder => Text(builder, Black, "DO NOT", "BLOCK", "INTER", "SECTION"));
        yield return Build("prop_sign_road_03m", NoUTurn);
        yield return Build("prop_sign_road_04a", builder => Text(builder, Red, "NO", "PARKING", "ANY", "TIME"));
        yield return Build("prop_sign_road_05a", Pedestrian);
        yield return Build("prop_sign_road_05e", builder => Turn(builder, -1));
        yield return Build("prop_sign_road_05f", builder => Turn(builder, 1));
        foreach (
            (string letter, string limit) in new[]
            {
                ("a", "15"),
                ("b", "5"),
                ("d", "25"),
                ("e", "35"),
                ("f", "50"),
                ("g", "60"),
                ("j", "55"),
            }
        )
        {
            yield return Build("prop_sign_road_06" + letter, builder => SpeedLimit(builder, limit));
        }
    }

    /// <summary>The box of a sign's face: the front of the sheet and the paint on it.</summary>
    public static (Vector3D Min, Vector3D Max) Face(Model sign)
    {
        Bounds face = Bounds.Empty;
        foreach (ref readonly MeshTriangle triangle in sign.Mesh.Triangles)
        {
            Bounds own = Bounds.Of(triangle);
            face = own.Max.Y <= FaceY ? face.With(own) : face;
        }

        return (face.Min, face.Max);
    }

    private static Model Build(string name, Func<MeshBuilder, double> addPlate)
    {
        var builder = new MeshBuilder();
        double top = addPlate(builder);
        builder.AddBox(new(-0.035, FaceY + PlateThickness, 0), new(0.035, 0.035, top), Metal);
        return Model.Of(name, ObjectClass.Sign, [builder.Build()]);
    }

    private static double Stop(MeshBuilder builder)
    {
        const double middle = 2.3;
        AddPlate(builder, Corners(8, 0.4, middle, Math.PI / 8), White);
        AddFace(builder, Corners(8, 0.37, middle, Math.PI / 8), 1, Red);
        StrokeFont.Write(builder, "STOP", At(0, middle, 2), 0.24, White);
        return middle;
    }

    private static double Yield(MeshBuilder builder)
    {
        const double middle = 2.3;
        AddPlate(builder, Corners(3, 0.5, middle, -Math.PI / 2), Red);
        AddFace(builder, Corners(3, 0.28, middle, -Math.PI / 2), 1, White);
        StrokeFont.Write(builder, "YIELD", At(0, middle + 0.06, 2), 0.07, Red);
        return middle;
    }

    private static double DoNotEnter(MeshBuilder builder)
    {
        const double middle = 2.3;
        AddPlate(builder, Corners(4, 0.54, middle, Math.PI / 4), White);
        AddFace(builder, Corners(24, 0.35, middle, 0), 1, Red);
        StrokeFont.AddStroke(builder, At(-0.2, middle, 2), At(0.2, middle, 2), 0.05, White);
        return middle;
    }

    private static double NoUTurn(MeshBuilder builder)
    {
        const double middle = 2.25;
        AddPlate(builder, Corners(4, 0.44, middle, Math.PI / 4), White);
        AddFace(builder, Corners(24, 0.28, middle, 0), 1, Red);
        AddFace(builder, Corners(24, 0.23, middle, 0), 2, White);
        StrokeFont.Write(builder, "U", At(0.01, middle, 3), 0.2, Black);
        StrokeFont.AddStroke(builder, At(-0.16, middle + 0.16, 4), At(0.16, middle - 0.16, 4), 0.025, Red);
        return middle;
    }

    private static double Pedestrian(MeshBuilder builder)
    {
        double middle = Diamond(builder);
        AddFace(builder, Corners(12, 0.05, middle + 0.2, 0), 2, Black);
        StrokeFont.AddStroke(builder, At(0, middle + 0.12, 2), At(0, middle - 0.04, 2), 0.035, Black);
        StrokeFont.AddStroke(builder, At(0, middle - 0.04, 2), At(-0.1, middle - 0.25, 2), 0.025, Black);
        StrokeFont.AddStroke(builder, At(0, middle - 0.04, 2), At(0.11, middle - 0.24, 2), 0.025, Black);
        StrokeFont.AddStroke(builder, At(0, middle + 0.1, 2), At(0.13, middle, 2), 0.02, Black);
        StrokeFont.AddStroke(builder, At(0, middle + 0.1, 2), At(-0.12, middle - 0.02, 2), 0.02, Black);
        return middle;
    }

    private static double Turn(MeshBuilder builder, int side)
    {
        double middle = Diamond(builder);
        StrokeFont.AddStroke(builder, At(-side * 0.12, middle - 0.22, 2), At(-side * 0.12, middle + 0.08, 2), 0.04, Black);
        StrokeFont.AddStroke(builder, At(-side * 0.12, middle + 0.08, 2), At(side * 0.1, middle + 0.08, 2), 0.04, Black);
        builder.AddTriangle(At(side * 0.24, middle + 0.08, 2), At(side * 0.08, middle + 0.19, 2), At(side * 0.08, middle - 0.03, 2), Black);
        return middle;
    }

    private static double Diamond(MeshBuilder builder)
    {
        const double middle = 2.35;
        AddPlate(builder, Corners(4, 0.54, middle, 0), Black);
        AddFace(builder, Corners(4, 0.51, middle, 0), 1, Yellow);
        return middle;
    }

    private static double SpeedLimit(MeshBuilder builder, string limit)
    {
        const double middle = 2.3;
        AddPlate(builder, Rectangle(0.3, 0.38, middle), Black);
        AddFace(builder, Rectangle(0.285, 0.365, middle), 1, White);
        StrokeFont.Write(builder, "SPEED", At(0, middle + 0.26, 2), 0.09, Black);
        StrokeFont.Write(builder, "LIMIT", At(0, middle + 0.11, 2), 0.09, Black);
        StrokeFont.Write(builder, limit, At(0, middle - 0.17, 2), 0.27, Black);
        return middle;
    }

    private static double Text(MeshBuilder builder, Rgb colour, params string[] lines)
    {
        const double middle = 2.2;
        AddPlate(builder, Rectangle(0.3, 0.38, middle), colour);
        AddFace(builder, Rectangle(0.285, 0.365, middle), 1, White);
        for (int line = 0; line < lines.Length; line++)
        {
            StrokeFont.Write(builder, lines[line], At(0, middle + 0.25 - (line * 0.165), 2), 0.085, colour);
        }

        return middle;
    }

    /// <summary>Adds a sheet whose front lies in the face's plane, with bare metal behind.</summary>
    private static void AddPlate(MeshBuilder builder, Vector3D[] outline, Rgb colour)
    {
        builder.AddPrism(outline, new Vector3D(0, PlateThickness, 0), Metal);
        AddFace(builder, outline, 0, colour);
    }

    /// <summary>Adds a layer of paint in front of the plate; a higher layer lies in front of a lower one.</summary>
    private static void AddFace(MeshBuilder builder, Vector3D[] outline, int layer, Rgb colour) =>
        builder.AddPolygon(outline.Select(corner => corner with { Y = FaceY - (Ink * (layer + 0.5)) }).ToArray(), colour);

    private static Vector3D At(double x, double z, int layer) => new(x, FaceY - (Ink * (layer + 0.5)), z);

    private static Vector3D[] Rectangle(double halfWidth, double halfHeight, double middle) =>
        [
            new(-halfWidth, FaceY, middle - halfHeight),
            new(halfWidth, FaceY, middle - halfHeight),
            new(halfWidth, FaceY, middle + halfHeight),
            new(-halfWidth, FaceY, middle + halfHeight),
        ];

    private static Vector3D[] Corners(int count, double radius, double middle, double firstTurn) =>
        Enumerable
            .Range(0, count)
            .Select(i => firstTurn + (2 * Math.PI * i / count))
            .Select(turn => new Vector3D(radius * Math.Cos(turn), FaceY, middle + (radius * Math.Sin(turn))))
            .ToArray();
}
