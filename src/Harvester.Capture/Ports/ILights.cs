using Harvester.Capture.Labels;

namespace Harvester.Capture.Ports;

/// <summary>
/// The traffic lights of which it is known what they show: in the real game those that the harvester itself drives, since the game tells
/// nobody what its own show; in a simulated one all.
/// </summary>
public interface ILights
{
    /// <summary>The state that a light was set to by whoever drives it, and shows in the picture of a frame; null for one that the real game drives, and around a change, when a picture may show either.</summary>
    /// <param name="entity">The light's handle.</param>
    /// <param name="gameFrame">The game's count of frames when the scene was read.</param>
    LightState? SetStateOf(int entity, long gameFrame);
}
