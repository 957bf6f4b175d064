using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using Harvester.Datasets.Exports.Assembly;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Json;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>Looks whether an exported dataset is whole, and whether its labels are what its format asks for.</summary>
public static class DatasetValidator
{
    /// <summary>Whether a folder is a finished dataset.</summary>
    public static bool IsDataset(string folder) => new DatasetFolder(folder).IsFinished;

    /// <summary>Whether a folder holds an export that was begun and not finished.</summary>
    public static bool IsUnfinished(string folder) => new DatasetFolder(folder).IsBegun;

    /// <summary>Validates a dataset.</summary>
    /// <param name="folder">Its folder.</param>
    /// <param name="cancellation">Stops between two images.</param>
    /// <exception cref="DatasetFormatException">export.json is malformed.</exception>
    public static DatasetValidation Validate(string folder, CancellationToken cancellation = default)
    {
        (DatasetFormat format, ExportOptions options, IReadOnlyDictionary<string, int> framesOfSplits) = ReadManifest(
            Path.Combine(folder, DatasetFolder.Manifest));
        var dataset = new DatasetContent(folder, options);
        var problems = new List<SessionProblem>();
        foreach (SessionProblem problem in ImageProblems(folder).Concat(format.Check(dataset)))
        {
            cancellation.ThrowIfCancellationRequested();
            problems.Add(problem);
        }

        foreach ((string split, int counted) in framesOfSplits)
        {
            int found = dataset.FramesOfSplits.GetValueOrDefault(split);
            if (found != counted)
            {
                problems.Add(new SessionProblem(
                    DatasetFolder.Manifest, null, $"it counts {counted} frames in {split}, but there are {found}."));
            }
        }

        return new DatasetValidation(format.Name, dataset.FramesOfSplits.Values.Sum(), problems);
    }

    private static IEnumerable<SessionProblem> ImageProblems(string folder)
    {
        IEnumerable<string> images = Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Where(file => Path.GetExtension(file) is ".png" or ".bmp" or ".jpg").Order(StringComparer.Ordinal);
        foreach (string image in images)
        {
            if (Damage(image) is { } damage)
            {
                yield return new SessionProblem(Path.GetRelativePath(folder, image).Replace('\\', '/'), null, damage);
            }
        }
    }

    private static string? Damage(string image)
    {
        try
        {
            _ = ImageHeader.Read(image);
            return null;
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }

    private static (DatasetFormat Format, ExportOptions Options, IReadOnlyDictionary<string, int> FramesOfSplits) ReadManifest(string path)
    {
        try
        {
            using JsonDocument manifest = JsonInput.Read(path);
            (DatasetFormat format, ExportOptions options) = ExportPlan.Parse(DatasetAssembly.PlanIn(manifest));
            JsonFields frames = new JsonFields(manifest.RootElement).Fields("framesOfSplits");
            return (format, options,
                options.Splits.Splits.ToDictionary(split => split.Name, split => frames.Integer(split.Name), StringComparer.Ordinal));
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{DatasetFolder.Manifest} is malformed: {e.Message}", e);
        }
    }
}
