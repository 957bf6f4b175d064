using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;
using Harvester.Datasets.Exports.Masks;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Yolo;

/// <summary>
/// Ultralytics YOLO with outlines: a class and the corners of one polygon a line. Of an object that something cuts in pieces the largest
/// piece is written. See docs/exports/yolo.md.
/// </summary>
internal sealed class YoloSegmentWriter(ExportOptions options) : IDatasetWriter
{
    private readonly YoloFiles _files = new(options);

    public int Write(ExportFrame frame, FrameOutput output)
    {
        IReadOnlyDictionary<int, InstancePixels> pixels = InstancePixels.AllOf(frame.Mask!);
        return YoloFiles.Write(frame, output, [.. frame.Objects.Where(label => pixels.ContainsKey(label.Id)).Select(label => Line(label, pixels[label.Id]))]);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => [_files.DataFile()];

    private string Line(ObjectLabel label, InstancePixels pixels)
    {
        ImageSize image = pixels.Map.Image;
        IEnumerable<string> corners = pixels.Outlines()[0].Select(corner => Numbers.Row(YoloFiles.Decimals, corner.X / image.Width, corner.Y / image.Height));
        return Numbers.Text(_files.NumberOf(label.Class)) + " " + string.Join(' ', corners);
    }
}
