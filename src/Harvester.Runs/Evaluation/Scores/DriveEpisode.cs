using System.Text.Json.Serialization;
using Harvester.Geometry;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Evaluation.Scores;

/// <summary>A drive from one start with one seed.</summary>
public sealed class DriveEpisode
{
    /// <summary>Evaluates an episode.</summary>
    /// <param name="seed">Random seed of town, traffic and noise.</param>
    /// <param name="near">The start, world, metres; null for the middle of the roads.</param>
    /// <param name="samples">The samples, at equal intervals.</param>
    /// <param name="wantedMetres">Distance to drive, metres, greater than 0.</param>
    /// <param name="isStopped">Whether it was cancelled or failed.</param>
    public DriveEpisode(int seed, Vector2D? near, IReadOnlyList<DriveSample> samples, double wantedMetres, bool isStopped)
    {
        Seed = seed;
        Near = near is { } place ? [place.X, place.Y] : null;
        Samples = samples;
        Score = EpisodeScore.Of(samples, wantedMetres);
        Figures = DriveFigures.Of(samples);
        Ending =
            Score.RouteCompletionFraction >= 1 ? "distance"
            : isStopped ? "stopped"
            : "time";
    }

    /// <summary>Random seed of town, traffic and noise.</summary>
    public int Seed { get; }

    /// <summary>The start, x and y, world, metres; null for the middle of the roads.</summary>
    public IReadOnlyList<double>? Near { get; }

    /// <summary>Why it ended: "distance", "time" for the time limit, or "stopped" if it was cancelled or failed.</summary>
    public string Ending { get; }

    /// <summary>The driving score and what it is made of.</summary>
    public EpisodeScore Score { get; }

    /// <summary>The figures.</summary>
    public DriveFigures Figures { get; }

    /// <summary>The samples.</summary>
    [JsonIgnore]
    public IReadOnlyList<DriveSample> Samples { get; }

    /// <summary>Seed and start, for display.</summary>
    [JsonIgnore]
    public string Name =>
        Near is { } near
            ? FormattableString.Invariant($"seed {Seed} at {near[0]:0.#}, {near[1]:0.#}")
            : FormattableString.Invariant($"seed {Seed}");
}
