using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Text;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>A harvest as the command line describes it.</summary>
public sealed record HarvestPlan
{
    /// <summary>Folder to write the session to.</summary>
    public required string Folder { get; init; }

    /// <summary>Whether an existing session in the folder is replaced.</summary>
    public required bool Overwrite { get; init; }

    /// <summary>Whether to continue what the same command left unfinished in the folder.</summary>
    public required bool Resume { get; init; }

    /// <summary>Options of capture and labelling. The table of faces is added when the game is built.</summary>
    public required HarvestOptions Options { get; init; }

    /// <summary>Number of frames, including those of other shards.</summary>
    public required int Frames { get; init; }

    /// <summary>Random seed of the world.</summary>
    public required int Seed { get; init; }

    /// <summary>The trial of a plan that this harvest is; null for a harvest of its own.</summary>
    public TrialSetting? Trial { get; init; }

    /// <summary>The scenario that is staged; null for ordinary traffic.</summary>
    public PlannedScenario? Scenario { get; init; }

    /// <summary>The survey of paint that this harvest is; null for one that drives.</summary>
    public SimulatedSurvey? Survey { get; init; }

    /// <summary>Vertical field of view, degrees.</summary>
    public required double FovDegrees { get; init; }

    /// <summary>File of the road network; null for a town generated from the seed.</summary>
    public required string? Roads { get; init; }

    /// <summary>Folder of an imported log, whose traffic is replayed on its roads; null for none.</summary>
    public string? Log { get; init; }

    /// <summary>Table of the paint measured on the roads; null for none.</summary>
    public string? Paint { get; init; }

    /// <summary>Files of traffic lights and street lamps; empty to generate them.</summary>
    public required IReadOnlyList<string> Props { get; init; }

    /// <summary>Table of faces that takes precedence over the built-in one; null for none.</summary>
    public required string? Faces { get; init; }

    /// <summary>Start position, world, metres; null for the middle of the road network.</summary>
    public required Vector2D? Near { get; init; }

    /// <summary>How much happens in the world, and what the game reports about it; the other values are defaults.</summary>
    public required SimulationOptions Variety { get; init; }

    /// <summary>Name of the weather, as in the game.</summary>
    public required string Weather { get; init; }

    /// <summary>Day of the year, 1 to 366.</summary>
    public required int DayOfYear { get; init; }

    /// <summary>Time of day at the start.</summary>
    public required TimeSpan TimeOfDay { get; init; }

    /// <summary>How much of the light the pictures show.</summary>
    public required Detail Detail { get; init; }

    /// <summary>Look-ahead of the lane indicators.</summary>
    public required LookAhead LookAhead { get; init; }

    /// <summary>Lane width of ordinary roads, metres.</summary>
    public required double LaneWidth { get; init; }

    /// <summary>Lane width of narrow roads, metres.</summary>
    public required double NarrowLaneWidth { get; init; }

    /// <summary>Faults of the real game that the simulated game imitates.</summary>
    public required GameQuirks Quirks { get; init; }

    /// <summary>The value of --quirks; null if it is not given.</summary>
    public required string? QuirksText { get; init; }

    /// <summary>What is changed in the course of the harvest, in the order of time.</summary>
    public IReadOnlyList<TimedChange> Changes { get; init; } = [];

    /// <summary>What is harvested, in words.</summary>
    public string Description
    {
        get
        {
            if (Survey is { } survey)
            {
                return FormattableString.Invariant($"{survey.Plan.RoadMetres / 1000:0.00} km of roads from above in ")
                    + $"{Counted.Of(Frames, "picture")} of {Options.Image.Width} x {Options.Image.Height}";
            }

            string shard = Options.Shard.Count > 1 ? $"shard {Options.Shard} of " : "";
            return Options.Rig is { } rig
                ? $"{shard}{Counted.Of(Frames / rig.Cameras.Count, "moment")} of the rig {rig.Name}, "
                    + $"{Counted.Of(rig.Cameras.Count, "view")} and {Counted.Of(rig.Lidars.Count, "LiDAR")}"
                    + (rig.Radars.Count > 0 ? $" and {Counted.Of(rig.Radars.Count, "radar")}" : "")
                    + " each, "
                    + FormattableString.Invariant($"about {RigBudget.SecondsPerMoment(rig, Options.Masks, Options.Depth):G2} s per moment")
                : $"{shard}{Counted.Of(Frames, "frame")} of {Options.Image.Width} x {Options.Image.Height}";
        }
    }
}
