using System.Text.Encodings.Web;
using System.Text.Json;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Evaluation.Scores;

/// <summary>Drives on disk: their settings, figures, scores and events.</summary>
public sealed record DriveRecord
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "drive.json";

    private static readonly JsonSerializerOptions Json = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    /// <summary>Version of the file format.</summary>
    public int FormatVersion { get; } = 1;

    /// <summary>The options of the drive; "controller" is always among them.</summary>
    public required IReadOnlyDictionary<string, string> Settings { get; init; }

    /// <summary>Whether the drive was completed; false if it was cancelled or a fault ended it.</summary>
    public required bool IsWhole { get; init; }

    /// <summary>The figures of all episodes together.</summary>
    public required DriveFigures Figures { get; init; }

    /// <summary>The distribution of the episodes' scores, and the infractions per kilometre.</summary>
    public required DriveSummary Summary { get; init; }

    /// <summary>The episodes.</summary>
    public required IReadOnlyList<DriveEpisode> Episodes { get; init; }

    /// <summary>The lane departures of the controller.</summary>
    public required IReadOnlyList<DriveEvent> Departures { get; init; }

    /// <summary>The collisions.</summary>
    public required IReadOnlyList<DriveEvent> Collisions { get; init; }

    /// <summary>Evaluates drives.</summary>
    /// <param name="settings">The options of the drives.</param>
    /// <param name="episodes">The drives; none if none had begun.</param>
    /// <param name="isWhole">Whether all were completed.</param>
    public static DriveRecord Of(IReadOnlyDictionary<string, string> settings, IReadOnlyList<DriveEpisode> episodes, bool isWhole = true)
    {
        ArgumentNullException.ThrowIfNull(episodes);
        return new DriveRecord
        {
            Settings = settings,
            IsWhole = isWhole,
            Figures = DriveFigures.Of([.. episodes.SelectMany(episode => episode.Samples)]),
            Summary = DriveSummary.Of(episodes),
            Episodes = episodes,
            Departures = Events(episodes, samples => new LaneKeeping(samples).Departures),
            Collisions = Events(episodes, Harvester.Runs.Evaluation.Figures.Collisions.In),
        };
    }

    /// <summary>Writes the record as JSON.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(Stream stream)
    {
        ArgumentNullException.ThrowIfNull(stream);
        JsonSerializer.Serialize(stream, this, Json);
        stream.WriteByte((byte)'\n');
    }

    private static DriveEvent[] Events(IReadOnlyList<DriveEpisode> episodes, Func<IReadOnlyList<DriveSample>, IEnumerable<int>> find) =>
        [.. episodes.SelectMany((episode, index) => find(episode.Samples).Select(i => DriveEvent.At(episode.Samples[i], index)))];
}
