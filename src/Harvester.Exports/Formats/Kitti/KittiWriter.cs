using System.Text;
using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// Writes KITTI object detection: training/image_2, label_2, calib, oxts and, with a LiDAR, velodyne with a file per frame, the images of
/// the other cameras of a rectified rig, and lists of the splits. See docs/exports/kitti.md.
/// </summary>
internal sealed class KittiWriter(ExportOptions options) : IDatasetWriter
{
    private const string ListPrefix = "list ";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        KittiPlace place = KittiPlace.Of(frame);
        string name = $"{frame.Index + place.ToReference:D6}";
        output.Image($"training/image_{place.Slot}/{name}{frame.ImageExtension}", frame);
        if (place.IsFirst)
        {
            output.Text($"training/oxts/{name}.txt", KittiOxts.Line(frame) + "\n");
        }

        if (!place.IsReference)
        {
            return new WrittenObjects(0);
        }

        var lines = new StringBuilder();
        int objects = 0;
        foreach (KittiBox box in KittiBox.Of(frame, options.Names))
        {
            string truncated = Numbers.Row(KittiDecimals.Fraction, box.Label.TruncatedFraction);
            lines
                .Append(box.Type)
                .Append(' ')
                .Append(truncated)
                .Append(' ')
                .Append(KittiClasses.OcclusionOf(box.Label))
                .Append(' ')
                .Append(box.Fields(place.Rig.PlaceOf(KittiRig.Reference, frame)))
                .Append('\n');
            objects++;
            KittiLeaning.Add(output, $"{name}.txt", Numbers.Text(objects), box);
        }

        Box2D[] ignored = [.. KittiBox.IgnoredIn(frame)];
        foreach (Box2D box in ignored)
        {
            lines
                .Append(KittiClasses.DontCare)
                .Append(" -1 -1 -10 ")
                .Append(KittiBox.Sides(box))
                .Append(" -1 -1 -1 -1000 -1000 -1000 -10\n");
        }

        output.Text($"training/label_2/{name}.txt", lines.ToString());
        KittiVelodyne? points = KittiVelodyne.Of(frame);
        if (points is not null)
        {
            output.File($"training/velodyne/{name}.bin", points.Write);
        }

        output.Text(
            $"training/calib/{name}.txt",
            KittiCalibration.Text(
                place.Rig.Projections(frame),
                points?.ToCamera(place.Rig.MountOf(KittiRig.Origin, frame)),
                "R0_rect:",
                "Tr_velo_to_cam:",
                "Tr_imu_to_velo:",
                points?.FromInertial
            )
        );
        output.Part(ListPrefix + frame.Split, name);
        return new WrittenObjects(objects, ignored.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(ListPrefix, System.StringComparison.Ordinal))
            .Select(part => new AggregateFile($"ImageSets/{part[ListPrefix.Length..]}.txt", [AggregateSection.Lines(part)]))
            .Append(KittiLeaning.Table());
}
