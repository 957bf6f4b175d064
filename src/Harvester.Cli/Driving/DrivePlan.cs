using System.Collections.Generic;
using Harvester.Driving.Controllers;
using Harvester.Evaluation.Noise;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Driving;

/// <summary>What the command line asks of a drive.</summary>
internal sealed record DrivePlan
{
    /// <summary>Who drives.</summary>
    public required ControllerPlan Controller { get; init; }

    /// <summary>Decides everything that is left to chance.</summary>
    public int Seed { get; init; } = 1;

    /// <summary>The roads to drive on; null for a town made from the seed.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>Where to start, one drive after the other, metres, world; none for the middle of the roads.</summary>
    public IReadOnlyList<Vector2D> Starts { get; init; } = [];

    /// <summary>Factor on the number of vehicles.</summary>
    public double TrafficDensity { get; init; } = 1;

    /// <summary>Metres to drive from each start.</summary>
    public double Metres { get; init; } = 1000;

    /// <summary>Seconds of the game's time to drive from each start at most.</summary>
    public double Seconds { get; init; } = double.PositiveInfinity;

    /// <summary>Errors of the indicators; null for the truth.</summary>
    public NoiseLevels? Noise { get; init; }

    /// <summary>What lies between game and controller; null for nothing.</summary>
    public BridgePlan? Bridge { get; init; }
}
