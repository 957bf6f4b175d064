using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.DeepDriving;

/// <summary>
/// Checks DeepDriving datasets: images of the network's size, thirteen numbers per file, and a table with the same values.
/// </summary>
internal static class DeepDrivingCheck
{
    private const string Table = "indicators.csv";
    private const string Images = "images";
    private const int LeadingColumns = 5;

    /// <summary>Values have six decimals; the normalised ones are computed from unrounded values.</summary>
    private const double Rounding = 0.000002;

    private static readonly int Columns = DeepDrivingWriter.Header.Split(',').Length;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        string[] stems = [.. dataset.Files(Images).Select(image => Path.GetFileNameWithoutExtension(image))];
        return TableProblems(dataset, [.. stems])
            .Concat(LabelFiles.Strays(dataset, "indicators", stems))
            .Concat(LabelFiles.Strays(dataset, "normalised", stems));
    }

    private static IEnumerable<SessionProblem> TableProblems(DatasetContent dataset, HashSet<string> images)
    {
        if (!dataset.Has(Table))
        {
            yield return new SessionProblem(Table, null, "it is missing.");
        }

        foreach ((int number, string text) in dataset.Lines(Table))
        {
            string? problem =
                number > 1 ? RowProblem(dataset, text.Split(','), images)
                : text + "\n" == DeepDrivingWriter.Header ? null
                : "its columns are not those of the format.";
            if (problem is not null)
            {
                yield return new SessionProblem(Table, number, problem);
            }
        }

        foreach (string stem in images.Order(StringComparer.Ordinal))
        {
            yield return new SessionProblem(Table, null, $"image '{stem}' has no row.");
        }
    }

    private static string? RowProblem(DatasetContent dataset, string[] row, HashSet<string> images)
    {
        if (row.Length != Columns)
        {
            return $"it has {row.Length} columns instead of {Columns}.";
        }

        (string split, string image, string status, string fast) = (row[1], row[2], row[3], row[4]);
        if (!images.Remove(Path.GetFileNameWithoutExtension(image)) || !dataset.Has(image))
        {
            return $"its image '{image}' is missing, or occurs twice.";
        }

        if (!dataset.Splits.Contains(split))
        {
            return $"'{split}' is not a split of the export.";
        }

        dataset.Found(split);
        ImageSize expected = DeepDrivingWriter.Size;
        return dataset.Header(image) is { } header && header.Size != expected
                ? $"its image is {header.Size.Width} x {header.Size.Height}, not {expected.Width} x {expected.Height}."
            : !JsonNames.TryRead(status, out LaneStatus _) || fast is not ("0" or "1") ? "its status or fast has an unknown value."
            : Numbers.Parse(row.Skip(LeadingColumns)) is not { } numbers ? "a value is not a number."
            : ValueProblem(dataset, Path.GetFileNameWithoutExtension(image), fast == "1", numbers);
    }

    /// <summary>
    /// Checks the columns after the status: metres, flags, TORCS equivalents and normalised values, thirteen each, and fast.
    /// </summary>
    private static string? ValueProblem(DatasetContent dataset, string stem, bool isFast, double[] values)
    {
        int count = IndicatorTable.Count;
        double[] metres = values[..count];
        double[] normalised = values[(3 * count)..(4 * count)];
        if (values[count..(2 * count)].Any(flag => flag is not (0 or 1)))
        {
            return "a valid_ column is not 0 or 1.";
        }

        double[] expected = [.. DeepDrivingWriter.Normalised(values[(2 * count)..(3 * count)]), DeepDrivingNormalisation.Fast(isFast)];
        int wrong = Array.FindIndex(
            [.. expected.Zip(values.Skip(3 * count), (a, b) => Math.Abs(a - b))],
            difference => difference > Rounding
        );
        return wrong >= 0 ? $"normalised_{DeepDrivingWriter.Columns.Append("fast").ElementAt(wrong)} does not follow from its value."
            : Math.Abs(metres[0]) > Math.PI + Rounding ? "angle is not from -pi to pi."
            : FileProblem(dataset, $"indicators/{stem}.txt", metres) ?? FileProblem(dataset, $"normalised/{stem}.txt", normalised);
    }

    private static string? FileProblem(DatasetContent dataset, string name, double[] row)
    {
        string[] lines = [.. dataset.Lines(name).Select(line => line.Text)];
        return lines.Length == 1 && Numbers.Parse(lines[0].Split(' ')) is { } numbers && numbers.SequenceEqual(row)
            ? null
            : $"{name} is missing, or its numbers differ.";
    }
}
