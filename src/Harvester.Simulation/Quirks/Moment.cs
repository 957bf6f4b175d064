using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Quirks;

/// <summary>
/// Everything from which a picture of one state of the world is made, and the ground truth about it. It stays as it is while the world
/// moves on.
/// </summary>
/// <param name="State">Number of the state.</param>
/// <param name="Truth">The true camera, ego and entities, whatever the game reports.</param>
/// <param name="Moving">The shapes of moving objects.</param>
/// <param name="Lighting">Light and weather.</param>
/// <param name="Lights">Lamps near the camera.</param>
internal sealed record Moment(
    long State,
    SceneSnapshot Truth,
    IReadOnlyList<MeshInstance> Moving,
    Lighting Lighting,
    IReadOnlyList<LightSource> Lights
)
{
    private RenderScene? _scene;

    /// <summary>Handles of the entities that are hidden from pictures.</summary>
    public IReadOnlyCollection<int> Hidden { get; init; } = [];

    /// <summary>The lens of the camera.</summary>
    public required RenderLens Lens { get; init; }

    /// <summary>Whether hidden entities still cast shadows.</summary>
    public bool ShadowsRemain { get; init; }

    /// <summary>What is drawn of it, within the static part of a scene; made once, and to be called by one thread.</summary>
    public RenderScene SceneIn(RenderScene world) =>
        _scene ??= new RenderScene(world, Moving)
        {
            Lighting = Lighting,
            Lights = Lights,
            Hidden = Hidden,
            ShadowsRemain = ShadowsRemain,
        };
}
