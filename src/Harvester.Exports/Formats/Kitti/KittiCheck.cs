using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks KITTI object detection datasets: labels, calibrations and lists of the splits.</summary>
internal static class KittiCheck
{
    private const string Images = "training/image_2";
    private const string Labels = "training/label_2";
    private const string Calibrations = "training/calib";
    private const string Inertial = "training/oxts";
    private const string Points = "training/velodyne";
    private static readonly string[] OtherImages = ["training/image_0", "training/image_1", "training/image_3"];
    private const int Columns = 15;
    private const int BytesPerPoint = 16;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        IReadOnlyList<string> images = dataset.Files(Images);
        IReadOnlyDictionary<string, double> misses = KittiLeaning.MissesOf(dataset);
        Dictionary<string, int> frames = images.ToDictionary(image => Path.GetFileNameWithoutExtension(image), _ => 1);
        string[] others = [.. OtherImages.SelectMany(dataset.Files)];
        foreach (string frame in others.Select(image => Path.GetFileNameWithoutExtension(image)).Where(frames.ContainsKey))
        {
            frames[frame]++;
        }

        return images
            .SelectMany(image => ProblemsOf(dataset, image, misses))
            .Concat(LabelFiles.Strays(dataset, Labels, frames.Keys))
            .Concat(LabelFiles.Strays(dataset, Calibrations, frames.Keys))
            .Concat(LabelFiles.Strays(dataset, Inertial, frames.Keys))
            .Concat(OtherImages.SelectMany(folder => LabelFiles.Strays(dataset, folder, frames.Keys)))
            .Concat(frames.Keys.SelectMany(frame => KittiOxtsCheck.Problems(dataset, $"{Inertial}/{frame}.txt")))
            .Concat(SplitLists.Problems(dataset, split => $"ImageSets/{split}.txt", frames));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, string image, IReadOnlyDictionary<string, double> misses)
    {
        string frame = Path.GetFileNameWithoutExtension(image);
        var calibration = new KittiCalibrationCheck(
            dataset,
            $"{Calibrations}/{frame}.txt",
            "R0_rect:",
            "Tr_velo_to_cam:",
            "Tr_imu_to_velo:"
        );
        ImageHeader? header = dataset.Header(image);
        var columns = new KittiColumns(dataset.Options.Boxes ?? BoxKind.Cuboid);
        IEnumerable<SessionProblem> points = PointProblems(dataset, $"{Points}/{frame}.bin");
        return calibration
            .Problems.Concat(points)
            .Concat(
                LabelFiles.Problems(
                    dataset,
                    $"{Labels}/{frame}.txt",
                    (number, words) =>
                        ProblemOf(
                            words,
                            header?.Size,
                            calibration.P2,
                            columns,
                            misses.GetValueOrDefault($"{frame}.txt,{number}", KittiLeaning.MaxMissPixels)
                        )
                )
            );
    }

    private static IEnumerable<SessionProblem> PointProblems(DatasetContent dataset, string name) =>
        dataset.Has(name) && new FileInfo(dataset.PathOf(name)).Length % BytesPerPoint != 0
            ? [new SessionProblem(name, null, $"its length is no multiple of the {BytesPerPoint} bytes of a point.")]
            : [];

    private static string? ProblemOf(string[] words, ImageSize? image, double[]? projection, KittiColumns columns, double missPixels) =>
        words.Length != Columns ? $"it has {words.Length} columns instead of {Columns}."
        : Numbers.Parse(words.Skip(1)) is not { } numbers ? "a column after the type is not a number."
        : words[0] != KittiClasses.DontCare && numbers[0] is < 0 or > 1 ? "truncated is not 0 to 1."
        : columns.ProblemOf(words[0], numbers.AsSpan(1), image, projection, missPixels);
}
