using Harvester.Capture.Ports;

namespace Harvester.Driving.Session;

/// <summary>A clock with the game's time: no client counts as silent while the world is paused.</summary>
internal sealed class WorldClock(IWorld world) : IClock
{
    private const double MillisecondsPerSecond = 1000;

    public double Milliseconds => world.TimeSeconds * MillisecondsPerSecond;
}
