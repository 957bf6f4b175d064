using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using Harvester.Datasets.Exports.Assembly;
using Harvester.Datasets.Images;
using Harvester.Datasets.Json;
using Harvester.Datasets.Validation;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>Looks whether an exported dataset is whole, and whether its labels can be read where the format has a check.</summary>
public static class DatasetValidator
{
    /// <summary>Whether a folder is a finished dataset.</summary>
    public static bool IsDataset(string folder) => new DatasetFolder(folder).IsFinished;

    /// <summary>Validates a dataset.</summary>
    /// <param name="folder">Its folder.</param>
    /// <param name="cancellation">Stops between two images.</param>
    /// <exception cref="DatasetFormatException">export.json is malformed.</exception>
    public static DatasetValidation Validate(string folder, CancellationToken cancellation = default)
    {
        (DatasetFormat format, int frames) = ReadManifest(Path.Combine(folder, DatasetFolder.Manifest));
        string[] images = [.. Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Where(file => Path.GetExtension(file) is ".png" or ".bmp").Order(StringComparer.Ordinal)];
        var problems = new List<SessionProblem>();
        foreach (string image in images)
        {
            cancellation.ThrowIfCancellationRequested();
            try
            {
                _ = ImageHeader.Read(image);
            }
            catch (DatasetFormatException e)
            {
                problems.Add(new SessionProblem(Path.GetRelativePath(folder, image), null, e.Message));
            }
        }

        if (format.Check is { } check)
        {
            if (images.Length != frames)
            {
                problems.Add(new SessionProblem(DatasetFolder.Manifest, null, $"it counts {frames} frames, but there are {images.Length} images."));
            }

            problems.AddRange(check(folder));
        }

        return new DatasetValidation(format.Name, images.Length, problems);
    }

    private static (DatasetFormat Format, int Frames) ReadManifest(string path)
    {
        try
        {
            using JsonDocument manifest = JsonDocument.Parse(File.ReadAllBytes(path));
            var fields = new JsonFields(manifest.RootElement);
            return (ExportPlan.Parse(manifest.RootElement.GetProperty("plan").GetRawText()).Format, fields.WholeNumber("frames"));
        }
        catch (Exception e) when (e is JsonException or KeyNotFoundException)
        {
            throw new DatasetFormatException($"{DatasetFolder.Manifest} is malformed.", e);
        }
    }
}
