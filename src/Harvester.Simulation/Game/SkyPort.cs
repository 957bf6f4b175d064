using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Sets weather and time of day of the simulated game.</summary>
internal sealed class SkyPort(SimulatedGame game) : ISky
{
    public void Set(string? weather, TimeSpan? timeOfDay) => game.SetSky(weather, timeOfDay);

    public void Restore() => game.RestoreSky();
}
