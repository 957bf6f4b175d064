using Harvester.Capture.Labels;

namespace Harvester.Capture.Ports;

/// <summary>The traffic lights that the harvester itself drives. The game tells nobody what its own show.</summary>
public interface ILights
{
    /// <summary>The state to which a light was set and still is; null for one that the game drives.</summary>
    /// <param name="entity">The light's handle.</param>
    LightState? SetStateOf(int entity);
}
