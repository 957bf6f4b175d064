using GTA.Native;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>The game's traffic lights, by its natives.</summary>
internal sealed class GameTrafficLights : ITrafficLights
{
    /// <inheritdoc/>
    public bool Exists(int light) => Natives.EntityExists(light);

    /// <inheritdoc/>
    public void Override(int light, int value) => Natives.Call(Hash.SET_ENTITY_TRAFFICLIGHT_OVERRIDE, light, value);
}
