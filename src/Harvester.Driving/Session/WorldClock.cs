using Harvester.Capture.Ports;

namespace Harvester.Driving.Session;

/// <summary>The world's time in the place of the player's: nobody is silent for long while the world stands still.</summary>
internal sealed class WorldClock(IWorld world) : IClock
{
    private const double MillisecondsPerSecond = 1000;

    public double Milliseconds => world.TimeSeconds * MillisecondsPerSecond;
}
