using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Checks TuSimple datasets: every line is a frame with its image, and every lane has a column, or -2, for each row.</summary>
internal static class TuSimpleCheck
{
    private const int Absent = -2;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var named = new HashSet<string>(StringComparer.Ordinal);
        return dataset
            .Splits.SelectMany(split => SplitProblems(dataset, split, named))
            .Concat(
                dataset
                    .Folders("clips")
                    .SelectMany(dataset.Files)
                    .Where(image => !named.Contains(image))
                    .Select(image => new SessionProblem(image, null, "it is not in any list of labels."))
            );
    }

    private static IEnumerable<SessionProblem> SplitProblems(DatasetContent dataset, string split, HashSet<string> named)
    {
        string name = $"label_data_{split}.json";
        if (!dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing.");
        }

        foreach ((int number, string text) in dataset.Lines(name))
        {
            dataset.Found(split);
            if (Problem(dataset, text, named) is { } problem)
            {
                yield return new SessionProblem(name, number, problem);
            }
        }
    }

    private static string? Problem(DatasetContent dataset, string text, HashSet<string> named)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(text);
            return Problem(dataset, new JsonFields(document.RootElement), named);
        }
        catch (JsonException e)
        {
            return JsonFault.InLine(e);
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }

    private static string? Problem(DatasetContent dataset, JsonFields frame, HashSet<string> named)
    {
        string image = frame.Text("raw_file");
        double[] rows = frame.Numbers("h_samples");
        double[][] lanes = frame.Rows("lanes");
        if (!dataset.Has(image) || !named.Add(image))
        {
            return $"raw_file '{image}' is missing, or already has labels.";
        }

        if (dataset.Header(image) is not { } header)
        {
            return null;
        }

        return rows.Where((row, i) => row < 0 || row >= header.Size.Height || row != Math.Floor(row) || (i > 0 && row <= rows[i - 1])).Any()
                ? $"h_samples are not rising rows of the image of {header.Size.Width} x {header.Size.Height}."
            : lanes.Any(lane => lane.Length != rows.Length) ? $"a lane does not have {rows.Length} columns, one for each of h_samples."
            : lanes.Any(lane => lane.All(column => column == Absent)) ? "a lane has no points."
            : lanes
                .SelectMany(lane => lane)
                .Any(column => column != Absent && !(column >= 0 && column < header.Size.Width && column == Math.Floor(column)))
                ? $"a lane has a column that is neither -2 nor one of the image of {header.Size.Width} x {header.Size.Height}."
            : null;
    }
}
