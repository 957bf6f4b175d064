using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Yolo;

/// <summary>
/// Writes Ultralytics YOLO with boxes: per line, a class, centre and size, as fractions of the image. See docs/exports/yolo.md.
/// </summary>
internal sealed class YoloWriter(ExportOptions options) : IDatasetWriter
{
    private readonly YoloFiles _files = new(options);

    public WrittenObjects Write(ExportFrame frame, FrameOutput output) =>
        YoloFiles.Write(frame, output, [.. frame.Objects.Select(item => Line(item, frame.Label.Camera))]);

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) => [_files.DataFile()];

    private static string Line(ExportObject item, CameraLabel camera)
    {
        Box2D box = item.Box;
        return Numbers.Text(item.Class.Number)
            + " "
            + Numbers.Row(
                YoloFiles.Decimals,
                (box.XMin + box.XMax) / 2 / camera.Width,
                (box.YMin + box.YMax) / 2 / camera.Height,
                box.Width / camera.Width,
                box.Height / camera.Height
            );
    }
}
