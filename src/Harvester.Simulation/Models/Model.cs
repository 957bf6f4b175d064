using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>A model of the simulated game.</summary>
/// <param name="Name">Its name in the game, in lower case.</param>
/// <param name="Class">Its class.</param>
/// <param name="Min">Rear, left, lower corner of its box in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner of its box, metres.</param>
/// <param name="Variants">Its appearances, at least one: colours of a vehicle, steps of a walk, states of a signal (in the order of <see
/// cref="SignalState"/>).</param>
public sealed record Model(string Name, ObjectClass Class, Vector3D Min, Vector3D Max, IReadOnlyList<Mesh> Variants)
{
    /// <summary>Its first variant.</summary>
    public Mesh Mesh => Variants[0];

    /// <summary>Creates a model whose box encloses all variants.</summary>
    internal static Model Of(string name, ObjectClass objectClass, IReadOnlyList<Mesh> variants)
    {
        Bounds bounds = variants.Aggregate(Bounds.Empty, (collected, mesh) => collected.With(mesh.Bounds));
        return new Model(name, objectClass, bounds.Min, bounds.Max, variants);
    }

    /// <summary>The variant of any number, modulo their count: a colour by seed, a step by the distance walked.</summary>
    public Mesh Variant(int number) => Variants[(int)((uint)number % (uint)Variants.Count)];
}
