using System.Text.Json;
using Harvester.Datasets.Files;
using Harvester.Exports.Assembly;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Validation;

/// <summary>What export.json says of a dataset.</summary>
/// <param name="Format">The format.</param>
/// <param name="Options">The options of the export.</param>
/// <param name="FramesOfSplits">Number of frames in each split.</param>
/// <param name="Files">Number of files in the manifest; null for a dataset of an earlier version, which has no manifest.</param>
internal sealed record DatasetHeader(
    DatasetFormat Format,
    ExportOptions Options,
    IReadOnlyDictionary<string, int> FramesOfSplits,
    int? Files
)
{
    /// <summary>Reads the export.json of a dataset.</summary>
    /// <exception cref="DatasetFormatException">It is invalid.</exception>
    public static DatasetHeader Read(string folder)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(Path.Combine(folder, DatasetFolder.Header));
            var header = new JsonFields(document.RootElement);
            (DatasetFormat format, ExportOptions options) = ExportPlan.Parse(DatasetAssembly.PlanIn(header));
            JsonFields frames = header.Fields("framesOfSplits");
            return new DatasetHeader(
                format,
                options,
                options.Splits.Splits.ToDictionary(split => split.Name, split => frames.Integer(split.Name), StringComparer.Ordinal),
                header.Has("files") ? header.Integer("files") : null
            );
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{DatasetFolder.Header} is malformed: {JsonFault.InText(e)}", e);
        }
    }
}
