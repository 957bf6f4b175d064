using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Evaluation.Noise;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Driving;

/// <summary>A drive as the command line describes it.</summary>
public sealed record DriveSettings
{
    /// <summary>The controller.</summary>
    public required ControllerPlan Controller { get; init; }

    /// <summary>Random seed of the first episode; each further start has the next one, so that towns and traffic differ.</summary>
    public int Seed { get; init; } = 1;

    /// <summary>Seeds, each for an episode from each start; empty for <see cref="Seed"/>.</summary>
    public IReadOnlyList<int> Seeds { get; init; } = [];

    /// <summary>The road network; null for a town generated from the seed.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>The paint measured on the roads; null for none.</summary>
    public PaintTable? Paint { get; init; }

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

    /// <summary>Number of episodes that are driven at the same time, if there is no bridge.</summary>
    public int Jobs { get; init; } = 1;

    /// <summary>Seed and start of each episode.</summary>
    public IReadOnlyList<(int Seed, Vector2D? Start)> Episodes
    {
        get
        {
            Vector2D?[] starts = Starts.Count > 0 ? [.. Starts.Select(start => (Vector2D?)start)] : [null];
            return Seeds.Count > 0
                ? [.. Seeds.SelectMany(seed => starts.Select(start => (seed, start)))]
                : [.. starts.Select((start, i) => (Seed + i, start))];
        }
    }

    /// <summary>The bridge between game and controller; null for none.</summary>
    public BridgePlan? Bridge { get; init; }
}
