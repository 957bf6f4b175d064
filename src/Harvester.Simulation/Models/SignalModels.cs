using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Traffic lights by the game's names. The foot of the pole is the origin, the road and any arm are towards -x, and the lenses look towards
/// -y, against the traffic that they stop.
/// </summary>
internal static class SignalModels
{
    private const double HeadHeight = 1.05;
    private const double HeadHalfWidth = 0.18;
    private const double HeadFront = 0.12;
    private const double HeadBack = 0.1;
    private const double VisorLength = 0.16;
    private static readonly Rgb Pole = new(92, 96, 98);
    private static readonly Rgb Housing = new(34, 36, 34);
    private static readonly Rgb[] Lit = [new(255, 46, 36), new(255, 184, 30), new(60, 255, 140)];

    private static readonly Dictionary<string, Func<MeshBuilder, IEnumerable<Vector3D>>> Frames = new()
    {
        ["prop_traffic_01a"] = builder => AddMast(builder, 8.5, [-8, -4.5]),
        ["prop_traffic_01b"] = builder => AddMast(builder, 6, [-5.5]),
        ["prop_traffic_01d"] = builder => AddMast(builder, 11, [-10.5, -7, -3.5]),
        ["prop_traffic_03a"] = AddPost,
        ["prop_traffic_03b"] = AddPost,
    };

    public static IEnumerable<Model> All() => Frames.Select(frame => Build(frame.Key, frame.Value));

    /// <summary>The box of each head of a model: housing and visors, without the backplate.</summary>
    public static IEnumerable<(Vector3D Min, Vector3D Max)> Heads(string model) =>
        Frames[model]
            (new MeshBuilder())
            .Select(middle =>
                (
                    middle - new Vector3D(HeadHalfWidth, HeadFront + VisorLength, HeadHeight / 2),
                    middle + new Vector3D(HeadHalfWidth, HeadBack, HeadHeight / 2)
                )
            );

    private static Model Build(string name, Func<MeshBuilder, IEnumerable<Vector3D>> addFrame) =>
        Model.Of(name, ObjectClass.TrafficLight, Enum.GetValues<SignalState>().Select(state => BuildState(addFrame, state)).ToArray());

    private static Mesh BuildState(Func<MeshBuilder, IEnumerable<Vector3D>> addFrame, SignalState state)
    {
        var builder = new MeshBuilder();
        foreach (Vector3D head in addFrame(builder).ToArray())
        {
            AddHead(builder, head, state);
        }

        return builder.Build();
    }

    /// <summary>Adds a pole with an arm over the road; returns the centres of its heads.</summary>
    private static IEnumerable<Vector3D> AddMast(MeshBuilder builder, double armLength, double[] heads)
    {
        const double armHeight = 5.9;
        builder.AddCylinder(new(0, 0, 0), new(0, 0, 6.4), 0.16, 0.11, 10, Pole);
        builder.AddCylinder(new(0, 0, armHeight), new(-armLength, 0, armHeight + 0.35), 0.1, 0.05, 8, Pole);
        foreach (double along in heads)
        {
            yield return new Vector3D(along, -0.18, armHeight + 0.2);
        }

        yield return new Vector3D(0, -0.3, 3.1);
    }

    private static IEnumerable<Vector3D> AddPost(MeshBuilder builder)
    {
        builder.AddCylinder(new(0, 0, 0), new(0, 0, 3.4), 0.09, 0.07, 10, Pole);
        builder.AddBox(new(-0.12, -0.16, 1.05), new(0.12, -0.05, 1.35), new(214, 170, 36));
        yield return new Vector3D(0, -0.25, 2.9);
    }

    private static void AddHead(MeshBuilder builder, Vector3D middle, SignalState state)
    {
        const double lensRadius = 0.12;
        const double lensStep = 0.33;
        double front = middle.Y - HeadFront;
        builder.AddBox(
            new(middle.X - HeadHalfWidth, front, middle.Z - (HeadHeight / 2)),
            new(middle.X + HeadHalfWidth, middle.Y + HeadBack, middle.Z + (HeadHeight / 2)),
            Housing
        );
        builder.AddBox(
            new(middle.X - 0.3, middle.Y + 0.02, middle.Z - 0.63),
            new(middle.X + 0.3, middle.Y + 0.04, middle.Z + 0.63),
            Housing.Scaled(0.6)
        );
        for (int lamp = 0; lamp < Lit.Length; lamp++)
        {
            bool burns = lamp == (int)state;
            var lens = new Vector3D(middle.X, front, middle.Z + ((1 - lamp) * lensStep));
            builder.AddCylinder(
                lens,
                lens - new Vector3D(0, 0.02, 0),
                lensRadius,
                lensRadius,
                14,
                burns ? Lit[lamp] : Lit[lamp].Scaled(0.16),
                burns ? Surface.Lamp : Surface.Matte
            );
            builder.AddBox(lens + new Vector3D(-0.14, -VisorLength, 0.13), lens + new Vector3D(0.14, 0, 0.145), Housing);
        }
    }
}
