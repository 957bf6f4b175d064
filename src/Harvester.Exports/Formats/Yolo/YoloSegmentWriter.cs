using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry.Cameras;

namespace Harvester.Exports.Formats.Yolo;

/// <summary>
/// Writes Ultralytics YOLO with outlines: per line, a class and the corners of one polygon, which joins the pieces of an object. See
/// docs/exports/yolo.md.
/// </summary>
internal sealed class YoloSegmentWriter(ExportOptions options) : IDatasetWriter
{
    private readonly YoloFiles _files = new(options);

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        var lines = new List<string>();
        foreach (ExportObject item in frame.Objects)
        {
            if (frame.PixelsOf(item.Label) is { } pixels)
            {
                lines.Add(Line(item.Class, pixels));
            }
        }

        return YoloFiles.Write(frame, output, lines);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) => [_files.DataFile()];

    private static string Line(DatasetClass kind, InstancePixels pixels)
    {
        ImageSize image = pixels.Map.Image;
        IEnumerable<string> corners = pixels
            .Contour()
            .Select(corner => Numbers.Row(YoloFiles.Decimals, corner.X / image.Width, corner.Y / image.Height));
        return Numbers.Text(kind.Number) + " " + string.Join(' ', corners);
    }
}
