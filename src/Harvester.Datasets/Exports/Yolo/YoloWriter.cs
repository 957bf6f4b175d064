using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;

namespace Harvester.Datasets.Exports.Yolo;

/// <summary>Ultralytics YOLO with boxes: a class, centre and size a line, in shares of the image. See docs/exports/yolo.md.</summary>
internal sealed class YoloWriter(ExportOptions options) : IDatasetWriter
{
    private readonly YoloFiles _files = new(options);

    public int Write(ExportFrame frame, FrameOutput output) => YoloFiles.Write(frame, output, [.. frame.Objects.Select(label => Line(label, frame.Label.Camera))]);

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => [_files.DataFile()];

    private string Line(ObjectLabel label, CameraLabel camera)
    {
        double centreX = (label.Box2D.XMin + label.Box2D.XMax) / 2;
        double centreY = (label.Box2D.YMin + label.Box2D.YMax) / 2;
        return Numbers.Text(_files.NumberOf(label.Class)) + " " + Numbers.Row(
            YoloFiles.Decimals,
            centreX / camera.Width, centreY / camera.Height, label.Box2D.Width / camera.Width, label.Box2D.Height / camera.Height);
    }
}
