using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Real time as the ticks give it, so that a harvest takes the same course on every machine.</summary>
internal sealed class ClockPort(SimulatedGame game) : IClock
{
    public double Milliseconds => game.ElapsedSeconds * 1000;
}
