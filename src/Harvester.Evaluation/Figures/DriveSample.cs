using System.Collections.Generic;
using Harvester.Geometry;

namespace Harvester.Evaluation.Figures;

/// <summary>The truth about one moment of a drive.</summary>
public sealed record DriveSample
{
    /// <summary>Time, seconds.</summary>
    public required double TimeSeconds { get; init; }

    /// <summary>Centre of the car, metres, world x and y.</summary>
    public required Vector2D Position { get; init; }

    /// <summary>Speed, m/s.</summary>
    public required double Speed { get; init; }

    /// <summary>Whether the controller that is judged drives; otherwise the car's own driver does.</summary>
    public required bool IsByController { get; init; }

    /// <summary>Whether the car was put there and did not drive there from the sample before.</summary>
    public bool IsTeleported { get; init; }

    /// <summary>Where the car is among the lanes; null in junctions, where none are painted.</summary>
    public LanePlacement? Lane { get; init; }

    /// <summary>Handles of the vehicles whose boxes overlap the car's.</summary>
    public IReadOnlyList<int> Touching { get; init; } = [];
}
