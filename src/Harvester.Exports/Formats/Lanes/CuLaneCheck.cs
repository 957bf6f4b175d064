using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Checks CULane datasets: every listed image has its points and its map, which agree with the flags of its line.</summary>
internal static class CuLaneCheck
{
    private const int MinNumbers = 4;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        Dictionary<string, int> images = dataset
            .Folders(".")
            .Select(folder => Path.GetFileName(folder))
            .Where(folder => folder.StartsWith("sequence-", StringComparison.Ordinal))
            .SelectMany(dataset.Files)
            .Where(file => !file.EndsWith(".txt", StringComparison.Ordinal))
            .ToDictionary(file => "/" + file, _ => 1);
        return SplitLists
            .Problems(dataset, split => $"list/{split}.txt", images)
            .Concat(images.Keys.SelectMany(image => LineProblems(dataset, image[1..])))
            .Concat(dataset.Splits.SelectMany(split => TruthProblems(dataset, split)));
    }

    private static string LinesOf(string image) => image[..image.LastIndexOf('.')] + ".lines.txt";

    private static IEnumerable<SessionProblem> LineProblems(DatasetContent dataset, string image)
    {
        ImageSize? size = dataset.Header(image)?.Size;
        return LabelFiles.Problems(
            dataset,
            LinesOf(image),
            (number, words) =>
                number > LanePlaces.Count ? $"it is more than the {LanePlaces.Count} lines of an image."
                : Numbers.Parse(words) is not { } numbers ? "a word is not a number."
                : numbers.Length < MinNumbers || numbers.Length % 2 != 0 ? "it must have pairs of numbers, two or more."
                : size is { } known ? PointProblem(numbers, known)
                : null
        );
    }

    private static string? PointProblem(double[] numbers, ImageSize size)
    {
        double above = size.Height;
        for (int i = 0; i < numbers.Length; i += 2)
        {
            (double x, double y) = (numbers[i], numbers[i + 1]);
            if (!(x >= 0 && x <= size.Width - 1 && y >= 0 && y < size.Height))
            {
                return $"point {(i / 2) + 1} does not lie in the image of {size.Width} x {size.Height}.";
            }

            if (y >= above || y != Math.Floor(y))
            {
                return "its rows are not whole numbers from the bottom upwards.";
            }

            above = y;
        }

        return null;
    }

    private static IEnumerable<SessionProblem> TruthProblems(DatasetContent dataset, string split)
    {
        string name = $"list/{split}_gt.txt";
        IEnumerator<(int Number, string Text)> listed = dataset.Lines($"list/{split}.txt").GetEnumerator();
        using (listed)
        {
            foreach ((int number, string text) in dataset.Lines(name))
            {
                string[] words = text.Split(' ');
                string? problem =
                    !listed.MoveNext() || words[0] != listed.Current.Text ? $"its image is not that of list/{split}.txt."
                    : words.Length != 2 + LanePlaces.Count || words.Skip(2).Any(flag => flag is not ("0" or "1"))
                        ? $"it must have an image, a map and {LanePlaces.Count} flags, each 0 or 1."
                    : TruthProblem(dataset, words);
                if (problem is not null)
                {
                    yield return new SessionProblem(name, number, problem);
                }
            }

            if (listed.MoveNext())
            {
                yield return new SessionProblem(name, null, $"'{listed.Current.Text}' is not in it.");
            }
        }
    }

    private static string? TruthProblem(DatasetContent dataset, string[] words)
    {
        (string image, string map) = (words[0][1..], words[1].TrimStart('/'));
        int lines = dataset.Lines(LinesOf(image)).Count();
        if (words.Skip(2).Count(flag => flag == "1") is var flags && flags != lines)
        {
            return $"it has {flags} flags that are 1, but {LinesOf(image)} has {lines} lines.";
        }

        if (!dataset.Has(map))
        {
            return $"'{map}' is missing.";
        }

        try
        {
            var drawn = PngDecoder.ReadLabelMap(dataset.PathOf(map));
            return dataset.Header(image) is { } header && header.Size != drawn.Image ? $"'{map}' does not have the size of its image."
                : drawn.Ids.Distinct().FirstOrDefault(id => id > LanePlaces.Count || (id > 0 && words[id + 1] == "0")) is var id and > 0
                    ? $"'{map}' has pixels of {id}, but no such line exists."
                : null;
        }
        catch (DatasetFormatException e)
        {
            return $"'{map}': {e.Message}";
        }
    }
}
