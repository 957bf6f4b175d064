using System.Globalization;
using Harvester.Datasets.Logs;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>
/// Checks scenarios: the two tables, and that every listed scenario is there, can be read, and has the steps, tracks and lanes of its row.
/// </summary>
internal static class MotionScenarioCheck
{
    private const string JsonExtension = ".json";

    /// <summary>Checks a dataset of GPUDrive's.</summary>
    public static IEnumerable<SessionProblem> GpuDriveProblems(DatasetContent dataset) =>
        Problems(dataset, GpuDriveReader.ReadAll)
            .Concat(
                Strays(
                    dataset,
                    dataset.Splits.SelectMany(dataset.Files).Where(name => name.EndsWith(JsonExtension, StringComparison.Ordinal))
                )
            );

    /// <summary>Checks a dataset of WOMD's.</summary>
    public static IEnumerable<SessionProblem> WomdProblems(DatasetContent dataset) =>
        Problems(dataset, WomdReader.Read)
            .Concat(Strays(dataset, dataset.Splits.Select(MotionScenarioWriter.RecordsOf).Where(dataset.Has)));

    private static IEnumerable<SessionProblem> Problems(DatasetContent dataset, Func<string, IEnumerable<LogReading>> read)
    {
        string[] columns = MotionScenarioWriter.FrameColumns.Split(',');
        foreach (
            (int number, string[] words, string? problem) in Rows(dataset, MotionScenarioWriter.Frames, MotionScenarioWriter.FrameColumns)
        )
        {
            if (
                problem is not null
                || !dataset.Splits.Contains(words[0])
                || Numbers.Parse([words[Array.IndexOf(columns, "time_seconds")]]) is null
            )
            {
                yield return new SessionProblem(MotionScenarioWriter.Frames, LineOf(number), problem ?? "its split or time is invalid.");
            }
            else
            {
                dataset.Found(words[0]);
            }
        }

        var files = new Dictionary<string, List<(int Number, string[] Words)>>(StringComparer.Ordinal);
        foreach (
            (int number, string[] words, string? problem) in Rows(
                dataset,
                MotionScenarioWriter.Scenarios,
                MotionScenarioWriter.ScenarioColumns
            )
        )
        {
            if (problem is not null)
            {
                yield return new SessionProblem(MotionScenarioWriter.Scenarios, LineOf(number), problem);
                continue;
            }

            if (!files.TryGetValue(words[0], out List<(int, string[])>? rows))
            {
                files.Add(words[0], rows = []);
            }

            rows.Add((number, words));
        }

        foreach ((string file, List<(int Number, string[] Words)> rows) in files)
        {
            foreach (SessionProblem problem in FileProblems(dataset, file, rows, read))
            {
                yield return problem;
            }
        }
    }

    /// <summary>The line of a problem; null for one of the file.</summary>
    private static int? LineOf(int number) => number == 0 ? null : number;

    private static IEnumerable<SessionProblem> FileProblems(
        DatasetContent dataset,
        string file,
        List<(int Number, string[] Words)> rows,
        Func<string, IEnumerable<LogReading>> read
    )
    {
        if (!dataset.Has(file))
        {
            yield return new SessionProblem(file, null, $"it is missing, but {MotionScenarioWriter.Scenarios} lists it.");
            yield break;
        }

        int index = 0;
        using IEnumerator<LogReading> scenarios = read(dataset.PathOf(file)).GetEnumerator();
        while (true)
        {
            string? problem = null;
            bool hasMore = false;
            try
            {
                hasMore = scenarios.MoveNext();
            }
            catch (DatasetFormatException e)
            {
                problem = e.Message;
            }

            if (problem is null && hasMore)
            {
                problem =
                    index == rows.Count ? $"it has more scenarios than {MotionScenarioWriter.Scenarios} lists."
                    : RowOf(scenarios.Current, rows[index].Words) is { } row && !row.SequenceEqual(rows[index].Words)
                        ? $"its scenario {index} is not that of line {rows[index].Number} of {MotionScenarioWriter.Scenarios}."
                    : ProblemOf(scenarios.Current);
                index++;
            }
            else if (problem is null && index < rows.Count)
            {
                problem = $"it has fewer scenarios than {MotionScenarioWriter.Scenarios} lists.";
            }

            if (problem is not null)
            {
                yield return new SessionProblem(file, null, problem);
            }

            if (problem is not null || !hasMore)
            {
                yield break;
            }
        }
    }

    /// <summary>The row of a scenario; the file, the split and the measured steps are not in it.</summary>
    private static string[] RowOf(LogReading reading, string[] words) =>
        [
            words[0],
            reading.Log.Id,
            words[2],
            Numbers.Text(reading.Log.Times.Count),
            words[4],
            Numbers.Text(reading.Log.Tracks.Count),
            Numbers.Text(reading.Log.Features.Count(feature => feature.Kind == LogFeatureKind.Lane)),
            Numbers.Text(reading.Log.Signals.SelectMany(step => step).Select(signal => signal.Lane).Distinct().Count()),
        ];

    private static string? ProblemOf(LogReading reading)
    {
        HashSet<long> lanes = [.. reading.Log.Features.Where(feature => feature.Kind == LogFeatureKind.Lane).Select(feature => feature.Id)];
        return reading.LeftOut.Count > 0 ? $"it has {reading.LeftOut.First().Key}."
            : reading.Log.Signals.SelectMany(step => step).Any(signal => !lanes.Contains(signal.Lane)) ? "a light is that of no lane in it."
            : null;
    }

    private static IEnumerable<SessionProblem> Strays(DatasetContent dataset, IEnumerable<string> files)
    {
        HashSet<string> listed =
        [
            .. Rows(dataset, MotionScenarioWriter.Scenarios, MotionScenarioWriter.ScenarioColumns).Select(row => row.Words[0]),
        ];
        return files
            .Where(name => !listed.Contains(name))
            .Select(name => new SessionProblem(name, null, $"it is not in {MotionScenarioWriter.Scenarios}."));
    }

    private static IEnumerable<(int Number, string[] Words, string? Problem)> Rows(DatasetContent dataset, string name, string header)
    {
        int columns = header.Split(',').Length;
        if (!dataset.Has(name))
        {
            yield return (0, [""], "it is missing.");
        }

        foreach ((int number, string text) in dataset.Lines(name))
        {
            string[] words = text.Split(',');
            string? problem =
                number == 1 ? (text == header ? null : "its columns are not those of this version.")
                : words.Length == columns ? null
                : string.Create(CultureInfo.InvariantCulture, $"it has {words.Length} columns, not {columns}.");
            if (number > 1 || problem is not null)
            {
                yield return (number, words, problem);
            }
        }
    }
}
