using System.Text.Json;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// Writes the label lines as typed tables, one Parquet file each, and the images. The values come from the text of the line, so that each
/// is the one that the session has. See docs/exports/parquet.md.
/// </summary>
internal sealed class ParquetDatasetWriter(ExportOptions options) : IDatasetWriter
{
    private readonly ClassCatalogue _classes = new(options);

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string image = $"images/{frame.Name}{frame.ImageExtension}";
        output.Image(image, frame);
        Dictionary<int, string> classes = frame.Objects.ToDictionary(item => item.Label.Id, item => item.Class.Name);
        int regions = frame.Label.IgnoreRegions.Count(region => _classes.Of(region.Class) is not null);
        var source = new TableFrame(
            frame.Index,
            frame.RecordingIndex,
            frame.Split,
            image,
            id => classes.GetValueOrDefault(id),
            NameOfRegion
        );
        using JsonDocument label = JsonDocument.Parse(frame.LabelText);
        foreach (LabelTable table in LabelTables.All)
        {
            try
            {
                RowEncoder rows = table.Encode(source, label.RootElement);
                if (!rows.IsEmpty)
                {
                    output.Part(table.Name, rows.ToPart());
                }
            }
            catch (DatasetFormatException e)
            {
                throw frame.Problem(e.Message);
            }
        }

        return new WrittenObjects(classes.Count, regions);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        LabelTables.All.Select(table => new AggregateFile(
            table.FileName,
            [AggregateSection.Binary(table.Name, (stream, rows) => ParquetTable.Write(table, stream, rows))]
        ));

    private string? NameOfRegion(string name) =>
        JsonNames.TryRead(name, out ObjectClass kind) && _classes.Of(kind) is { } known ? known.Name : null;
}
