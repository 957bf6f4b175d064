using System;
using System.Collections.Generic;
using Harvester.Driving.Controllers;
using Harvester.Evaluation.Noise;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Driving;

/// <summary>A drive as the command line describes it.</summary>
internal sealed record DrivePlan
{
    /// <summary>The controller.</summary>
    public required ControllerPlan Controller { get; init; }

    /// <summary>Random seed.</summary>
    public int Seed { get; init; } = 1;

    /// <summary>The road network; null for a town generated from the seed.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>Start positions of the drives, world, metres; empty for the middle of the road network.</summary>
    public IReadOnlyList<Vector2D> Starts { get; init; } = [];

    /// <summary>Factor on the number of vehicles.</summary>
    public double TrafficDensity { get; init; } = 1;

    /// <summary>Distance to drive from each start, metres.</summary>
    public double Metres { get; init; } = 1000;

    /// <summary>Time limit for each start, seconds of game time.</summary>
    public double Seconds { get; init; } = double.PositiveInfinity;

    /// <summary>Noise of the indicators; null for none.</summary>
    public NoiseLevels? Noise { get; init; }

    /// <summary>Whether the steering is disturbed now and then.</summary>
    public bool IsDisturbed { get; init; }

    /// <summary>Size of the recorded images, pixels; null if nothing is recorded.</summary>
    public ImageSize? PictureSize { get; init; }

    /// <summary>The weather.</summary>
    public string Weather { get; init; } = "clear";

    /// <summary>The time of day at the start.</summary>
    public TimeSpan TimeOfDay { get; init; } = TimeSpan.FromHours(12);

    /// <summary>The day of the year, from 1.</summary>
    public int DayOfYear { get; init; } = new SimulationOptions().DayOfYear;

    /// <summary>The bridge between game and controller; null for none.</summary>
    public BridgePlan? Bridge { get; init; }
}
