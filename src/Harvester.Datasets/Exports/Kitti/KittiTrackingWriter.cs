using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;

namespace Harvester.Datasets.Exports.Kitti;

/// <summary>KITTI tracking: a sequence for each session, with one label and one calibration file each. See docs/exports/kitti-tracking.md.</summary>
internal sealed class KittiTrackingWriter : IDatasetWriter
{
    private const string LabelPrefix = "label ";
    private const string ListPrefix = "list ";

    public int Write(ExportFrame frame, FrameOutput output)
    {
        CameraLabel camera = frame.Label.Camera;
        if ((camera.Fx, camera.Fy, camera.Cx, camera.Cy) != (frame.SessionCamera.Fx, frame.SessionCamera.Fy, frame.SessionCamera.Cx, frame.SessionCamera.Cy))
        {
            throw frame.Problem("its camera has another calibration than the session's first frame, and kitti-tracking has one a sequence. Choose another format.");
        }

        string sequence = $"{frame.SessionIndex:D4}";
        output.Transfer($"training/image_02/{sequence}/{frame.FrameInSession:D6}{frame.ImageExtension}", frame.ImagePath);
        if (frame.FrameInSession == 0)
        {
            output.Text($"training/calib/{sequence}.txt", KittiCalibration.Text(camera, "R_rect", "Tr_velo_cam", "Tr_imu_velo"));
            output.Part(ListPrefix + frame.Split, sequence);
        }

        int written = 0;
        foreach (ObjectLabel label in frame.Objects)
        {
            if (KittiClasses.TypeOf(label.Class) is { } type && new KittiBox(label, camera) is { IsInImage: true } box)
            {
                output.Part(LabelPrefix + sequence, string.Join(
                    ' ',
                    Numbers.Text(frame.FrameInSession), Numbers.Text(label.Id), type, Numbers.Text(KittiClasses.LevelOf(label.TruncatedFraction)),
                    Numbers.Text(KittiClasses.OcclusionOf(label)), box.Fields()));
                written++;
            }
        }

        return written;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => parts.Select(part => new AggregateFile(
        part.StartsWith(LabelPrefix, StringComparison.Ordinal) ? $"training/label_02/{part[LabelPrefix.Length..]}.txt" : $"ImageSets/{part[ListPrefix.Length..]}.txt",
        [AggregateSection.Lines(part)]));
}
