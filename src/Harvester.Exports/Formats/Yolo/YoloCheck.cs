using Harvester.Exports.Checks;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.Yolo;

/// <summary>Checks Ultralytics YOLO labels: boxes have four numbers, outlines at least three corners.</summary>
internal static class YoloCheck
{
    private const string DataFile = "data.yaml";
    private const int BoxNumbers = 4;
    private const int MinCornerNumbers = 6;

    /// <summary>Coordinates are rounded to six decimals.</summary>
    private const double RoundingShare = 0.000002;

    public static IEnumerable<SessionProblem> BoxProblems(DatasetContent dataset) => Problems(dataset, BoxProblem);

    public static IEnumerable<SessionProblem> OutlineProblems(DatasetContent dataset) => Problems(dataset, OutlineProblem);

    private static IEnumerable<SessionProblem> Problems(DatasetContent dataset, Func<double[], string?> shapeProblem)
    {
        int exported = new ClassCatalogue(dataset.Options).All.Count;
        int classes = dataset.Lines(DataFile).Count(line => line.Text.StartsWith("  ", StringComparison.Ordinal));
        var stems = new HashSet<string>(StringComparer.Ordinal);
        return DataProblems(dataset, classes, exported)
            .Concat(
                dataset.Splits.SelectMany(split => SplitProblems(dataset, split, stems, words => ProblemOf(words, classes, shapeProblem)))
            );
    }

    private static IEnumerable<SessionProblem> DataProblems(DatasetContent dataset, int classes, int exported)
    {
        if (!dataset.Has(DataFile))
        {
            yield return new SessionProblem(DataFile, null, "it is missing.");
        }
        else if (classes != exported)
        {
            yield return new SessionProblem(DataFile, null, $"it names {classes} classes, but {exported} were exported.");
        }

        foreach ((int number, string text) in dataset.Lines(DataFile))
        {
            string[] words = text.Split(": ");
            if (words.Length == 2 && words[1].StartsWith("images/", StringComparison.Ordinal) && dataset.Files(words[1]).Count == 0)
            {
                yield return new SessionProblem(DataFile, number, $"there are no images in {words[1]}.");
            }
        }
    }

    private static IEnumerable<SessionProblem> SplitProblems(
        DatasetContent dataset,
        string split,
        HashSet<string> stems,
        Func<string[], string?> problemOf
    )
    {
        var own = new List<string>();
        foreach (string image in dataset.Files($"images/{split}"))
        {
            string stem = Path.GetFileNameWithoutExtension(image);
            own.Add(stem);
            dataset.Found(split);
            if (!stems.Add(stem))
            {
                yield return new SessionProblem(image, null, "it occurs twice, here or in another split.");
            }

            foreach (SessionProblem problem in LabelFiles.Problems(dataset, $"labels/{split}/{stem}.txt", (_, words) => problemOf(words)))
            {
                yield return problem;
            }
        }

        foreach (SessionProblem problem in LabelFiles.Strays(dataset, $"labels/{split}", own))
        {
            yield return problem;
        }
    }

    private static string? ProblemOf(string[] words, int classes, Func<double[], string?> shapeProblem) =>
        Numbers.Parse(words) is not { } numbers ? "a value is not a number."
        : !(numbers[0] >= 0 && numbers[0] < classes && numbers[0] == Math.Floor(numbers[0]))
            ? $"class {words[0]} is not one of the {classes} classes in data.yaml."
        : numbers.Skip(1).Any(number => number is < 0 or > 1) ? "a coordinate is not 0 to 1."
        : shapeProblem(numbers[1..]);

    private static string? BoxProblem(double[] box)
    {
        if (box.Length != BoxNumbers)
        {
            return $"a box has {BoxNumbers} numbers, not {box.Length}.";
        }

        return box[2] > 0 && box[3] > 0 && IsInImage(box[0], box[2]) && IsInImage(box[1], box[3])
            ? null
            : "its box does not lie in the image, or has no area.";
    }

    private static bool IsInImage(double centre, double size) =>
        centre - (size / 2) >= -RoundingShare && centre + (size / 2) <= 1 + RoundingShare;

    private static string? OutlineProblem(double[] corners)
    {
        if (corners.Length < MinCornerNumbers || corners.Length % 2 != 0)
        {
            return $"an outline has two numbers for each of three corners or more, not {corners.Length}.";
        }

        double[] xs = [.. corners.Where((_, i) => i % 2 == 0)];
        double[] ys = [.. corners.Where((_, i) => i % 2 == 1)];
        return xs.Max() > xs.Min() && ys.Max() > ys.Min() ? null : "its outline has no area.";
    }
}
