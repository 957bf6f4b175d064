using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>The game's time as a harvest last read it.</summary>
internal sealed class HarvestTime(GamePorts game)
{
    private readonly DrivingPace _pace = new();

    /// <summary>Number of the game frame.</summary>
    public long GameFrame { get; private set; }

    /// <summary>The game's time, seconds.</summary>
    public double Seconds { get; private set; }

    /// <summary>Real time that the running game takes for a second of its own time; null in the first second of game time.</summary>
    public double? RealSecondsPerGameSecond => _pace.RealSecondsPerGameSecond;

    /// <summary>Reads the time.</summary>
    public void Read()
    {
        GameFrame = game.World.GameFrame;
        Seconds = game.World.TimeSeconds;
    }

    /// <summary>Reads the time of the running game, between two frames.</summary>
    public void ReadRunning()
    {
        Read();
        _pace.Observe(game.Clock.Milliseconds, Seconds);
    }
}
