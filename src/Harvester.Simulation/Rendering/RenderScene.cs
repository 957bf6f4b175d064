namespace Harvester.Simulation.Rendering;

/// <summary>What is drawn: the static world, the entities of the moment, and the light.</summary>
public sealed class RenderScene
{
    private HashSet<int>? _hidden;

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

    /// <summary>Handles of the entities that are not drawn; empty by default. Rays hit them all the same.</summary>
    public IReadOnlyCollection<int> Hidden
    {
        get;
        set
        {
            field = value;
            _hidden = value.Count == 0 ? null : [.. value];
        }
    } = [];

    /// <summary>Whether hidden entities still cast shadows.</summary>
    public bool ShadowsRemain { get; set; }

    internal InstanceSet Static { get; }

    internal InstanceSet Dynamic { get; private set; } = new([]);

    /// <summary>The entities that cast no shadow; null if all do.</summary>
    internal HashSet<int>? Shadowless => ShadowsRemain ? null : _hidden;

    /// <summary>Whether an entity is not drawn.</summary>
    internal bool IsHidden(int handle) => _hidden?.Contains(handle) == true;

    /// <summary>Replaces the moving instances: vehicles, people, signals.</summary>
    public void SetDynamic(IEnumerable<MeshInstance> instances)
    {
        ArgumentNullException.ThrowIfNull(instances);
        Dynamic = new InstanceSet(instances);
    }
}
