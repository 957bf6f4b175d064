using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Checks the classes and instances of the points of samples: one of each for each point, and both agree.</summary>
/// <param name="dataset">The dataset.</param>
/// <param name="data">The records of sample_data by their tokens.</param>
/// <param name="categories">The records of category by their tokens.</param>
internal sealed class NuScenesSegmentCheck(
    DatasetContent dataset,
    IReadOnlyDictionary<string, JsonFields> data,
    IReadOnlyDictionary<string, JsonFields> categories
)
{
    private const int BytesPerPoint = 5 * sizeof(float);
    private const int MaxPoints = 4 << 20;

    /// <summary>The first problem of a table; null for none.</summary>
    /// <param name="table">Its name.</param>
    /// <param name="records">Its records by their tokens.</param>
    /// <exception cref="DatasetFormatException">A record or a file cannot be read.</exception>
    public string? ProblemOf(string table, IReadOnlyDictionary<string, JsonFields> records)
    {
        HashSet<int> known = [.. categories.Values.Select(category => category.Integer("index"))];
        foreach ((string token, JsonFields record) in records)
        {
            string file = record.Text("filename");
            string? problem =
                token != record.Text("sample_data_token") ? "its token is not that of its sample_data."
                : !data.TryGetValue(token, out JsonFields points) || !points.Boolean("is_key_frame")
                    ? "its sample_data_token is no file of a sample."
                : !dataset.Has(file) ? $"its file '{file}' is missing."
                : !dataset.Has(points.Text("filename")) ? $"the points '{points.Text("filename")}' are missing."
                : ProblemOf(table, file, points.Text("filename"), known);
            if (problem is not null)
            {
                return $"{token}: {problem}";
            }
        }

        return null;
    }

    private string? ProblemOf(string table, string file, string points, HashSet<int> known)
    {
        long count = new FileInfo(dataset.PathOf(points)).Length / BytesPerPoint;
        if (count > MaxPoints)
        {
            return $"the points '{points}' are more than {MaxPoints}.";
        }

        int[]? categoriesOf = table == NuScenesSegments.Classes ? ClassesIn(file, (int)count) : CategoriesIn(file, (int)count);
        return categoriesOf is null ? $"its file '{file}' does not have a number for each of the {count} points."
            : Array.FindIndex(categoriesOf, category => !known.Contains(category)) is >= 0 and var at
                ? $"point {at} of '{file}' has the category {categoriesOf[at]}, which category.json does not have."
            : null;
    }

    private int[]? ClassesIn(string file, int count)
    {
        byte[] classes = InputFile.ReadAllBytes(dataset.PathOf(file), MaxPoints);
        return classes.Length == count ? [.. classes.Select(each => (int)each)] : null;
    }

    private int[]? CategoriesIn(string file, int count)
    {
        using FileStream stream = InputFile.OpenRead(dataset.PathOf(file));
        return NpzFile.Read(stream, NuScenesSegments.ArrayName, count) is { } numbers
            ? [.. numbers.Select(number => number / NuScenesSegments.CategoryFactor)]
            : null;
    }
}
