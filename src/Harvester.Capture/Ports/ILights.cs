using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Ports;

/// <summary>
/// The traffic lights whose state is known: in the real game those that the harvester drives itself, because the game does not report the
/// state of its own; in a simulated game all.
/// </summary>
public interface ILights
{
    /// <summary>
    /// The state to which a light was set and which the picture of a frame shows. Null for a light that the real game drives, and near a
    /// change, when the picture may show either state.
    /// </summary>
    /// <param name="entity">Handle of the light's entity.</param>
    /// <param name="gameFrame">The game's frame count when the scene was read.</param>
    LightState? SetStateOf(int entity, long gameFrame);
}
