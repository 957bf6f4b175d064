using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>The player's time: what the ticks were given, so that a harvest takes the same course on every machine.</summary>
internal sealed class ClockPort(SimulatedGame game) : IClock
{
    public double Milliseconds => game.ElapsedSeconds * 1000;
}
