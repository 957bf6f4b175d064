using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>A model of the simulated game.</summary>
/// <param name="Name">Its name in the game, small letters.</param>
/// <param name="Class">What kind of thing it is.</param>
/// <param name="Min">Rear, left, lower corner of its box in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner of its box, metres.</param>
/// <param name="Variants">Its looks, at least one: colours of a vehicle, steps of a walk, states of a signal (in the order of
/// <see cref="SignalState"/>).</param>
public sealed record Model(string Name, ObjectClass Class, Vector3D Min, Vector3D Max, IReadOnlyList<Mesh> Variants)
{
    /// <summary>Its first look.</summary>
    public Mesh Mesh => Variants[0];

    /// <summary>A model whose box is the one around all of its looks.</summary>
    internal static Model Of(string name, ObjectClass objectClass, IReadOnlyList<Mesh> variants)
    {
        Bounds bounds = variants.Aggregate(Bounds.Empty, (collected, mesh) => collected.With(mesh.Bounds));
        return new Model(name, objectClass, bounds.Min, bounds.Max, variants);
    }

    /// <summary>The look of any number, taken round the list: a colour by seed, a step by the distance walked.</summary>
    public Mesh Variant(int number) => Variants[(int)((uint)number % (uint)Variants.Count)];
}
