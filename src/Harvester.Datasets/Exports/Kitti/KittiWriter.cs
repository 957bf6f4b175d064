using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;

namespace Harvester.Datasets.Exports.Kitti;

/// <summary>KITTI object detection: training/image_2, label_2 and calib, a file a frame, and lists of the splits. See docs/exports/kitti.md.</summary>
internal sealed class KittiWriter : IDatasetWriter
{
    private const string ListPrefix = "list ";

    public int Write(ExportFrame frame, FrameOutput output)
    {
        string name = $"{frame.Index:D6}";
        output.Transfer($"training/image_2/{name}{frame.ImageExtension}", frame.ImagePath);
        string[] lines = [.. frame.Objects.Select(label => Line(label, frame.Label.Camera)).OfType<string>()];
        output.Text($"training/label_2/{name}.txt", string.Concat(lines));
        output.Text($"training/calib/{name}.txt", KittiCalibration.Text(frame.Label.Camera, "R0_rect:", "Tr_velo_to_cam:", "Tr_imu_to_velo:"));
        output.Part(ListPrefix + frame.Split, name);
        return lines.Length;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) =>
        parts.Select(part => new AggregateFile($"ImageSets/{part[ListPrefix.Length..]}.txt", [AggregateSection.Lines(part)]));

    private static string? Line(ObjectLabel label, CameraLabel camera) =>
        KittiClasses.TypeOf(label.Class) is { } type && new KittiBox(label, camera) is { IsInImage: true } box
            ? $"{type} {Numbers.Row(KittiDecimals.Fraction, label.TruncatedFraction)} {KittiClasses.OcclusionOf(label)} {box.Fields()}\n"
            : null;
}
