using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Models;

/// <summary>The lamps of the simulated lights as labels call them.</summary>
internal static class SignalStates
{
    public static LightState AsLight(this SignalState state) =>
        state switch { SignalState.Red => LightState.Red, SignalState.Amber => LightState.Amber, _ => LightState.Green };

    /// <summary>The lamp that burns; green where the state is not known.</summary>
    public static SignalState AsSignal(this LightState state) =>
        state switch { LightState.Red => SignalState.Red, LightState.Amber => SignalState.Amber, _ => SignalState.Green };
}
