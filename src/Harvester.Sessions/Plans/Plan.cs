namespace Harvester.Sessions.Plans;

/// <summary>The trials of an experiment, as a plan file describes them. File format: docs/plans.md.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Places">The places, at least one.</param>
public sealed record Plan(string Name, IReadOnlyList<PlanPlace> Places)
{
    /// <summary>Random seed of the world, and the origin of the seeds of the trials.</summary>
    public int Seed { get; init; }

    /// <summary>Names of weathers, at least one.</summary>
    public required IReadOnlyList<string> Weathers { get; init; }

    /// <summary>Times of day at which trials begin, at least one.</summary>
    public required IReadOnlyList<TimeSpan> Hours { get; init; }

    /// <summary>The cameras, at least one.</summary>
    public required IReadOnlyList<PlanCamera> Cameras { get; init; }

    /// <summary>Number of trials with the same place, weather, hour and camera.</summary>
    public int Repetitions { get; init; }

    /// <summary>Number of frames of a trial; with a rig, of moments.</summary>
    public int Frames { get; init; }

    /// <summary>Frames per second of the game's time.</summary>
    public double Hz { get; init; }

    /// <summary>Speed of the drive that is aimed at along a path, and the greatest one of the game's own driver, m/s.</summary>
    public double SpeedMetresPerSecond { get; init; }

    /// <summary>Factor on the number of moving vehicles.</summary>
    public double Traffic { get; init; }

    /// <summary>Factor on the number of people on foot.</summary>
    public double Pedestrians { get; init; }

    /// <summary>Factor on the number of parked vehicles.</summary>
    public double Parked { get; init; }

    /// <summary>The instance masks.</summary>
    public PlanMasks Masks { get; init; }

    /// <summary>Whether events are found.</summary>
    public bool Events { get; init; }

    /// <summary>Number of frames of a trial at a place, where its drive has a limit of time: fewer if the drive is shorter.</summary>
    public int FramesAt(PlanPlace place) =>
        (place ?? throw new ArgumentNullException(nameof(place))).Seconds is { } seconds
            ? Math.Max(1, (int)Math.Min(Frames, Math.Floor(seconds * Hz)))
            : Frames;
}
