using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Models;

/// <summary>Conversions between the lamps of the simulated lights and those of labels.</summary>
internal static class SignalStates
{
    public static LightState AsLight(this SignalState state) =>
        state switch
        {
            SignalState.Red => LightState.Red,
            SignalState.Amber => LightState.Amber,
            _ => LightState.Green,
        };

    /// <summary>The lit lamp; green if the state is unknown.</summary>
    public static SignalState AsSignal(this LightState state) =>
        state switch
        {
            LightState.Red => SignalState.Red,
            LightState.Amber => SignalState.Amber,
            _ => SignalState.Green,
        };
}
