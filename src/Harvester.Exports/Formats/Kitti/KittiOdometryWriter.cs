using System.Globalization;
using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// Writes KITTI odometry with SemanticKITTI's labels: a sequence for each place of a session and each camera that stands for itself. See
/// docs/exports/kitti-odometry.md.
/// </summary>
internal sealed class KittiOdometryWriter : IDatasetWriter
{
    private const string CalibrationPrefix = "calibration ";
    private const string PosePrefix = "pose ";
    private const string TimePrefix = "time ";
    private const string ListPrefix = "list ";
    private const int PoseDecimals = 9;
    private const int TimeDecimals = 6;

    /// <summary>The folder of a sequence.</summary>
    public static string FolderOf(string sequence) => $"sequences/{sequence}";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        KittiPlace place = KittiPlace.Of(frame);
        string sequence = SequenceOf(frame, place);
        string folder = FolderOf(sequence);
        int number = frame.FrameInSequence;
        output.Image($"{folder}/image_{place.Slot}/{number:D6}{frame.ImageExtension}", frame);
        if (place.IsFirst)
        {
            output.Text($"{folder}/oxts/data/{number:D10}.txt", KittiOxts.Line(frame) + "\n");
        }

        if (!place.IsReference)
        {
            return new WrittenObjects(0);
        }

        KittiVelodyne? points = KittiVelodyne.Of(frame);
        if (points is not null)
        {
            output.File($"{folder}/velodyne/{number:D6}.bin", points.Write);
            output.File($"{folder}/labels/{number:D6}.label", points.WriteLabels);
        }

        output.Part(
            CalibrationPrefix + sequence,
            KittiCalibration.OdometryText(place.Rig.Projections(frame), points?.ToCamera(place.Rig.MountOf(KittiRig.Origin, frame)))
        );
        output.Part(TimePrefix + sequence, frame.Label.TimeSeconds.ToString("R", CultureInfo.InvariantCulture));
        output.Part(
            PosePrefix + sequence,
            string.Join(
                ' ',
                PoseOf(place.Rig.PoseOf(KittiRig.Origin, frame)).Select(value => value.ToString("R", CultureInfo.InvariantCulture))
            )
        );
        if (number == 0)
        {
            output.Part(ListPrefix + frame.Split, sequence);
        }

        return new WrittenObjects(0);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        [
            .. Sequences(parts).SelectMany(sequence => FilesOf(sequence)),
            .. parts
                .Keys.Where(part => part.StartsWith(ListPrefix, StringComparison.Ordinal))
                .Select(part => new AggregateFile($"ImageSets/{part[ListPrefix.Length..]}.txt", [AggregateSection.Lines(part)])),
        ];

    private static IEnumerable<string> Sequences(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(PosePrefix, StringComparison.Ordinal))
            .Select(part => part[PosePrefix.Length..])
            .Order(StringComparer.Ordinal);

    private static IEnumerable<AggregateFile> FilesOf(string sequence) =>
        [
            new($"{FolderOf(sequence)}/calib.txt", [AggregateSection.Summary(CalibrationPrefix + sequence, WriteFirst)]),
            new($"{FolderOf(sequence)}/times.txt", [AggregateSection.Summary(TimePrefix + sequence, WriteTimes)]),
            new($"poses/{sequence}.txt", [AggregateSection.Summary(PosePrefix + sequence, WritePoses)]),
            new($"{FolderOf(sequence)}/poses.txt", [AggregateSection.Summary(PosePrefix + sequence, WritePoses)]),
        ];

    /// <summary>Cameras that belong together share a sequence, whose number is that of their first view.</summary>
    private static string SequenceOf(ExportFrame frame, KittiPlace place) =>
        $"{frame.SequenceIndex - (place.Rig.IsRectified ? place.View : 0):D2}";

    /// <summary>The matrix from a camera's frame (x right, y down, z forward) to the world: three rows of four.</summary>
    private static double[] PoseOf(Pose camera)
    {
        (Vector3D x, Vector3D y, Vector3D z, Vector3D t) = (camera.Axes.Right, camera.Axes.Up * -1, camera.Axes.Forward, camera.Position);
        return [x.X, y.X, z.X, t.X, x.Y, y.Y, z.Y, t.Y, x.Z, y.Z, z.Z, t.Z];
    }

    private static void WriteFirst(TextWriter writer, IEnumerable<string> lines) =>
        writer.Write(lines.First().Replace(KittiCalibration.LineMark, '\n'));

    private static void WriteTimes(TextWriter writer, IEnumerable<string> lines)
    {
        double? first = null;
        foreach (double time in lines.Select(line => double.Parse(line, CultureInfo.InvariantCulture)))
        {
            first ??= time;
            writer.Write(Numbers.Row(TimeDecimals, time - first.Value) + "\n");
        }
    }

    /// <summary>Writes each pose in the frame of the first.</summary>
    private static void WritePoses(TextWriter writer, IEnumerable<string> lines)
    {
        double[]? first = null;
        foreach (double[] pose in lines.Select(line => Numbers.Parse(line.Split(' '))!))
        {
            first ??= pose;
            double[] relative = new double[12];
            for (int row = 0; row < 3; row++)
            {
                for (int column = 0; column < 4; column++)
                {
                    for (int k = 0; k < 3; k++)
                    {
                        // The inverse of a rotation is its transpose.
                        double moved = pose[(4 * k) + column] - (column == 3 ? first[(4 * k) + 3] : 0);
                        relative[(4 * row) + column] += first[(4 * k) + row] * moved;
                    }
                }
            }

            writer.Write(Numbers.Row(PoseDecimals, relative) + "\n");
        }
    }
}
