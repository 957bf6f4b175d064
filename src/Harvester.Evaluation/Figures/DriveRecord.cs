using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Harvester.Evaluation.Figures;

/// <summary>A drive on disk: its settings, figures and events.</summary>
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

    /// <summary>Whether the drive was completed; false if it was cancelled.</summary>
    public required bool IsWhole { get; init; }

    /// <summary>The figures.</summary>
    public required DriveFigures Figures { get; init; }

    /// <summary>The lane departures of the controller.</summary>
    public required IReadOnlyList<DriveEvent> Departures { get; init; }

    /// <summary>The collisions.</summary>
    public required IReadOnlyList<DriveEvent> Collisions { get; init; }

    /// <summary>Evaluates a drive.</summary>
    /// <param name="settings">The options of the drive.</param>
    /// <param name="samples">Samples of the drive at equal intervals.</param>
    /// <param name="isWhole">Whether the drive was completed.</param>
    public static DriveRecord Of(IReadOnlyDictionary<string, string> settings, IReadOnlyList<DriveSample> samples, bool isWhole = true)
    {
        ArgumentNullException.ThrowIfNull(samples);
        return new DriveRecord
        {
            Settings = settings,
            IsWhole = isWhole,
            Figures = DriveFigures.Of(samples),
            Departures = [.. new LaneKeeping(samples).Departures.Select(i => DriveEvent.At(samples[i]))],
            Collisions = [.. Evaluation.Figures.Collisions.In(samples).Select(i => DriveEvent.At(samples[i]))],
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
}
