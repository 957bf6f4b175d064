using System;
using System.Collections.Generic;

namespace Harvester.Simulation.Rendering;

/// <summary>What is drawn: the static world, the entities of the moment, and the light.</summary>
public sealed class RenderScene
{
    /// <summary>Creates a scene of a static world; its search tree is built here, once.</summary>
    public RenderScene(IEnumerable<MeshInstance> staticInstances)
    {
        ArgumentNullException.ThrowIfNull(staticInstances);
        Static = new InstanceSet(staticInstances);
    }

    /// <summary>Creates a scene with the static world of another one.</summary>
    internal RenderScene(RenderScene world, IEnumerable<MeshInstance> moving)
    {
        Static = world.Static;
        Dynamic = new InstanceSet(moving);
    }

    /// <summary>Sun, sky and weather.</summary>
    public Lighting Lighting { get; set; } = new();

    /// <summary>Street lamps and headlights that light their surroundings at night; only those near the camera need be given.</summary>
    public IReadOnlyList<LightSource> Lights { get; set; } = [];

    internal InstanceSet Static { get; }

    internal InstanceSet Dynamic { get; private set; } = new([]);

    /// <summary>Replaces the moving instances: vehicles, people, signals.</summary>
    public void SetDynamic(IEnumerable<MeshInstance> instances)
    {
        ArgumentNullException.ThrowIfNull(instances);
        Dynamic = new InstanceSet(instances);
    }
}
