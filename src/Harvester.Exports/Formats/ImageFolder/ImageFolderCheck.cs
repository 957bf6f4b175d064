using Harvester.Exports.Checks;
using Harvester.Geometry;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.ImageFolder;

/// <summary>Checks image folders: every image has its row, and boxes, classes and track ids belong together.</summary>
internal sealed class ImageFolderCheck
{
    /// <summary>Pixels have three decimals, and so have widths and heights.</summary>
    private const double RoundingPixels = 0.002;

    private readonly DatasetContent _dataset;
    private readonly int _classes;
    private readonly HashSet<string> _named = new(StringComparer.Ordinal);

    private ImageFolderCheck(DatasetContent dataset)
    {
        _dataset = dataset;
        _classes = new ClassCatalogue(dataset.Options).All.Count;
    }

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var check = new ImageFolderCheck(dataset);
        return dataset.Splits.SelectMany(check.SplitProblems);
    }

    private IEnumerable<SessionProblem> SplitProblems(string split)
    {
        string folder = $"data/{split}";
        string name = $"{folder}/{ImageFolderWriter.Metadata}";
        return FrameLines
            .Problems(_dataset, name, row => Problem(row, split, folder))
            .Concat(
                _dataset
                    .Files(folder)
                    .Where(file => file != name && !_named.Contains(Path.GetFileName(file)))
                    .Select(file => new SessionProblem(file, null, $"{ImageFolderWriter.Metadata} has no row for it."))
            );
    }

    private string? Problem(JsonFields row, string split, string folder)
    {
        _dataset.Found(split);
        string file = row.Text("file_name");
        JsonFields objects = row.Fields("objects");
        double[][] boxes = objects.Rows("bbox", 4);
        double[] categories = objects.Numbers("categories");
        double[] tracks = objects.Numbers("track_ids");
        return !_dataset.Has($"{folder}/{file}") ? $"file_name '{file}' is not in {folder}."
            : !_named.Add(file) ? $"file_name '{file}' occurs twice, here or in another split."
            : categories.Length != boxes.Length || tracks.Length != boxes.Length ? "bbox, categories and track_ids are not of one length."
            : categories.Any(number => number < 0 || number >= _classes || number != Math.Floor(number))
                ? $"a category is not a whole number from 0 to {_classes - 1}."
            : tracks.Distinct().Count() != tracks.Length ? "a track id occurs twice."
            : _dataset.Header($"{folder}/{file}") is { } header
            && boxes.Concat(row.Rows("ignore_regions", 4)).Any(sides => !IsIn(header.Size.Bounds, sides))
                ? $"a box does not lie in the image of {header.Size.Width} x {header.Size.Height}, or has no area."
            : null;
    }

    private static bool IsIn(Box2D image, double[] sides) =>
        sides[2] > 0
        && sides[3] > 0
        && image.Contains(new Box2D(sides[0], sides[1], sides[0] + sides[2], sides[1] + sides[3]), RoundingPixels);
}
