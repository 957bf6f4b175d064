using System.Globalization;
using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks KITTI tracking datasets: the labels, the calibration and the list entry of every sequence.</summary>
internal static class KittiTrackingCheck
{
    private const string Images = "training/image_02";
    private const string Labels = "training/label_02";
    private const string Calibrations = "training/calib";
    private const string Seqmap = "training/evaluate_tracking.seqmap.training";
    private const int Columns = 17;

    private delegate string? ColumnCheck(ReadOnlySpan<double> columns, ImageSize? image);

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        IReadOnlyDictionary<string, double> misses = KittiLeaning.MissesOf(dataset);
        Dictionary<string, int> sequences = dataset
            .Folders(Images)
            .ToDictionary(folder => Path.GetFileName(folder), folder => dataset.Files(folder).Count);
        return sequences
            .Keys.SelectMany(sequence => ProblemsOf(dataset, sequence, misses))
            .Concat(LabelFiles.Strays(dataset, Labels, sequences.Keys))
            .Concat(LabelFiles.Strays(dataset, Calibrations, sequences.Keys))
            .Concat(SeqmapProblems(dataset, sequences))
            .Concat(SplitLists.Problems(dataset, split => $"ImageSets/{split}.txt", sequences));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(
        DatasetContent dataset,
        string sequence,
        IReadOnlyDictionary<string, double> misses
    )
    {
        string labels = $"{Labels}/{sequence}.txt";
        var calibration = new KittiCalibrationCheck(dataset, $"{Calibrations}/{sequence}.txt", "R_rect", "Tr_velo_cam", "Tr_imu_velo");
        Dictionary<int, ImageSize?> frames = dataset
            .Files($"{Images}/{sequence}")
            .ToDictionary(
                image => int.Parse(Path.GetFileNameWithoutExtension(image), CultureInfo.InvariantCulture),
                image => dataset.Header(image)?.Size
            );
        var tracks = new TrackCheck();
        var columns = new KittiColumns(dataset.Options.Boxes ?? BoxKind.Cuboid);
        return calibration.Problems.Concat(
            LabelFiles.Problems(
                dataset,
                labels,
                (_, words) =>
                    ProblemOf(
                        words,
                        frames,
                        tracks,
                        (n, image) =>
                            columns.ProblemOf(
                                words[2],
                                n,
                                image,
                                calibration.P2,
                                misses.GetValueOrDefault($"{sequence}.txt,{words[0]} {words[1]}", KittiLeaning.MaxMissPixels)
                            )
                    )
            )
        );
    }

    private static IEnumerable<SessionProblem> SeqmapProblems(DatasetContent dataset, Dictionary<string, int> sequences)
    {
        IEnumerable<(int Number, string Text)> lines = dataset.Lines(Seqmap);
        HashSet<string> listed = [.. lines.Select(line => line.Text)];
        return sequences
            .Select(sequence => $"{sequence.Key} empty 000000 {sequence.Value:D6}")
            .Where(line => !listed.Contains(line))
            .Select(line => new SessionProblem(Seqmap, null, $"it has no line '{line}'."));
    }

    private static string? ProblemOf(string[] words, Dictionary<int, ImageSize?> frames, TrackCheck tracks, ColumnCheck problemOf)
    {
        if (words.Length != Columns)
        {
            return $"it has {words.Length} columns instead of {Columns}.";
        }

        return Numbers.Parse(words.Where((_, column) => column != 2)) is not { } numbers ? "a column other than the type is not a number."
            : !frames.TryGetValue((int)numbers[0], out ImageSize? image) || numbers[0] != Math.Floor(numbers[0])
                ? $"frame {words[0]} has no image."
            : words[2] != KittiClasses.DontCare && numbers[2] is not (0 or 1 or 2) ? "truncated is not 0, 1 or 2."
            : tracks.ProblemOf((int)numbers[0], words[1], words[2]) ?? problemOf(numbers.AsSpan(3), image);
    }
}
