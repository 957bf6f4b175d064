using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// Writes KITTI tracking: a sequence per place, with one label file and one calibration file each. See docs/exports/kitti-tracking.md.
/// </summary>
internal sealed class KittiTrackingWriter(ExportOptions options) : IDatasetWriter
{
    private const string FramePrefix = "frame ";
    private const string LabelPrefix = "label ";
    private const string ListPrefix = "list ";
    private const string SeqmapPrefix = "training/evaluate_tracking.seqmap.";

    /// <summary>TrackEval's name of the training set.</summary>
    private const string WholeSet = "training";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string sequence = $"{frame.SequenceIndex:D4}";
        string number = Numbers.Text(frame.FrameInSequence);
        output.Image($"training/image_02/{sequence}/{frame.FrameInSequence:D6}{frame.ImageExtension}", frame);
        output.Part($"{FramePrefix}{frame.Split} {sequence}", number);
        if (frame.FrameInSequence == 0)
        {
            output.Text(
                $"training/calib/{sequence}.txt",
                KittiCalibration.Text(KittiRig.Of(null).Projections(frame), null, "R_rect", "Tr_velo_cam", "Tr_imu_velo")
            );
            output.Part(ListPrefix + frame.Split, sequence);
        }

        int objects = 0;
        foreach (KittiBox box in KittiBox.Of(frame, options.Names))
        {
            output.Part(
                LabelPrefix + sequence,
                string.Join(
                    ' ',
                    number,
                    Numbers.Text(box.Label.Id),
                    box.Type,
                    Numbers.Text(KittiClasses.LevelOf(box.Label.TruncatedFraction)),
                    Numbers.Text(KittiClasses.OcclusionOf(box.Label)),
                    box.Fields(Vector3D.Zero)
                )
            );
            KittiLeaning.Add(output, $"{sequence}.txt", $"{number} {box.Label.Id}", box);
            objects++;
        }

        Box2D[] ignored = [.. KittiBox.IgnoredIn(frame)];
        foreach (Box2D box in ignored)
        {
            output.Part(
                LabelPrefix + sequence,
                $"{number} -1 {KittiClasses.DontCare} -1 -1 -10 {KittiBox.Sides(box)} -1000 -1000 -1000 -10 -1 -1 -1"
            );
        }

        return new WrittenObjects(objects, ignored.Length);
    }

    /// <summary>A sequence without objects has an empty label file, because readers require it.</summary>
    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        (string Split, string Sequence, int Frames)[] sequences =
        [
            .. parts
                .Where(part => part.Key.StartsWith(FramePrefix, StringComparison.Ordinal))
                .Select(part => (part.Key.Split(' ')[1], part.Key.Split(' ')[2], part.Value))
                .OrderBy(sequence => sequence.Item2, StringComparer.Ordinal),
        ];
        return sequences
            .Select(sequence => new AggregateFile(
                $"training/label_02/{sequence.Sequence}.txt",
                [AggregateSection.Lines(LabelPrefix + sequence.Sequence)]
            ))
            .Concat(sequences.GroupBy(sequence => sequence.Split).SelectMany(split => ListsOf(split.Key, split)))
            .Concat(sequences.Any(sequence => sequence.Split == WholeSet) ? [] : [Seqmap(WholeSet, sequences)])
            .Append(KittiLeaning.Table());
    }

    private static IEnumerable<AggregateFile> ListsOf(string split, IEnumerable<(string Split, string Sequence, int Frames)> sequences) =>
        [new($"ImageSets/{split}.txt", [AggregateSection.Lines(ListPrefix + split)]), Seqmap(split, sequences)];

    /// <summary>The format that the benchmark and TrackEval read: sequence, an unused word, first frame, number of frames.</summary>
    private static AggregateFile Seqmap(string set, IEnumerable<(string Split, string Sequence, int Frames)> sequences) =>
        new(
            SeqmapPrefix + set,
            [
                AggregateSection.Literal(
                    string.Concat(sequences.Select(sequence => $"{sequence.Sequence} empty 000000 {sequence.Frames:D6}\n"))
                ),
            ]
        );
}
