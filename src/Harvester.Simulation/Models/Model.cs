using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>A model of the simulated game.</summary>
/// <param name="Name">Its name in the game, in lower case.</param>
/// <param name="Class">Its class.</param>
/// <param name="Min">Rear, left, lower corner of its box in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner of its box, metres.</param>
/// <param name="Variants">Its appearances, at least one: colours of a vehicle, postures of a person, states of a signal (in the order of
/// <see cref="SignalState"/>).</param>
public sealed record Model(string Name, ObjectClass Class, Vector3D Min, Vector3D Max, IReadOnlyList<Mesh> Variants)
{
    /// <summary>The riders of a two-wheeler, in its frame; empty for everything else. They are entities of their own.</summary>
    public IReadOnlyList<Model> Riders { get; init; } = [];

    /// <summary>The light of its lamps; null unless it is a vehicle.</summary>
    public VehicleLampMeshes? Lamps { get; init; }

    /// <summary>Its first variant.</summary>
    public Mesh Mesh => Variants[0];

    /// <summary>The joints of each variant of a person, in the model's frame, metres; empty for other models.</summary>
    public IReadOnlyList<Skeleton> Skeletons { get; init; } = [];

    /// <summary>Distance that a person walks in a stride, two steps, metres; 0 for other models.</summary>
    internal double StrideMetres { get; init; }

    /// <summary>Usual walking speed of a person, metres per second; 0 for other models.</summary>
    internal double Pace { get; init; }

    /// <summary>Creates a model whose box encloses all variants.</summary>
    internal static Model Of(string name, ObjectClass objectClass, IReadOnlyList<Mesh> variants)
    {
        Bounds bounds = variants.Aggregate(Bounds.Empty, (collected, mesh) => collected.With(mesh.Bounds));
        return new Model(name, objectClass, bounds.Min, bounds.Max, variants);
    }

    /// <summary>The variant of any number, modulo their count: a colour by seed, a step by the distance walked.</summary>
    public Mesh Variant(int number) => Variants[(int)((uint)number % (uint)Variants.Count)];
}
