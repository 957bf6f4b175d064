using Harvester.Geometry;

namespace Harvester.Runs.Evaluation.Figures;

/// <summary>The true state at one moment of a drive.</summary>
public sealed record DriveSample
{
    /// <summary>Game time, seconds.</summary>
    public required double TimeSeconds { get; init; }

    /// <summary>Centre of the car, world x and y, metres.</summary>
    public required Vector2D Position { get; init; }

    /// <summary>Speed, m/s.</summary>
    public required double Speed { get; init; }

    /// <summary>Whether the controller drives, not the built-in driver.</summary>
    public required bool IsByController { get; init; }

    /// <summary>Whether the car was teleported since the previous sample.</summary>
    public bool IsTeleported { get; init; }

    /// <summary>The car's place among the lanes; null in junctions, which have no markings.</summary>
    public LanePlacement? Lane { get; init; }

    /// <summary>Handles of the vehicles whose boxes overlap the car's.</summary>
    public IReadOnlyList<int> Touching { get; init; } = [];

    /// <summary>What the game has counted since the beginning of the episode.</summary>
    public DriveCounters Counters { get; init; }
}
