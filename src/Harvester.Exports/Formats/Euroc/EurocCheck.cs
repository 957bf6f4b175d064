using System.Globalization;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.Euroc;

/// <summary>Checks EuRoC sequences: the columns and times of every table, that images exist, and that attitudes are quaternions.</summary>
internal static class EurocCheck
{
    private const int ImuNumbers = 6;
    private const int StateNumbers = 16;
    private const int FirstOfQuaternion = 3;
    private const int Quaternion = 4;
    private const int FirstBias = 10;
    private const double LengthTolerance = 1e-6;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset.Splits.SelectMany(split =>
            dataset
                .Folders(split)
                .SelectMany(sequence => SequenceProblems(dataset, split, EurocFiles.FolderOf(split, Path.GetFileName(sequence))))
        );

    private static IEnumerable<SessionProblem> SequenceProblems(DatasetContent dataset, string split, string folder)
    {
        int cameras = 0;
        foreach (string camera in dataset.Folders(folder).Where(name => Path.GetFileName(name).StartsWith("cam", StringComparison.Ordinal)))
        {
            cameras++;
            var listed = new HashSet<string>(StringComparer.Ordinal);
            foreach (
                SessionProblem problem in TableProblems(
                    dataset,
                    camera,
                    EurocFiles.ImageColumns,
                    words => ImageProblem(dataset, camera, words, listed)
                )
            )
            {
                yield return problem;
            }

            dataset.Found(split, listed.Count);
            foreach (string image in dataset.Files($"{camera}/data").Where(image => !listed.Contains(image)))
            {
                yield return new SessionProblem(image, null, $"it is not in {camera}/{EurocFiles.Table}.");
            }
        }

        if (cameras == 0)
        {
            yield return new SessionProblem(folder, null, "it has no camera.");
        }

        string imu = $"{folder}/{EurocFiles.Imu}";
        string states = $"{folder}/{EurocFiles.States}";
        string gnss = $"{folder}/{EurocFiles.Gnss}";
        IEnumerable<SessionProblem> located = dataset.Folders(folder).Contains(gnss)
            ? TableProblems(dataset, gnss, EurocFiles.GnssColumns, GnssProblem)
            : [];
        foreach (
            SessionProblem problem in TableProblems(dataset, imu, EurocFiles.ImuColumns, ImuProblem)
                .Concat(located)
                .Concat(TableProblems(dataset, states, EurocFiles.StateColumns, StateProblem))
        )
        {
            yield return problem;
        }
    }

    private static IEnumerable<SessionProblem> TableProblems(
        DatasetContent dataset,
        string folder,
        string columns,
        Func<string[], string?> problemOf
    )
    {
        string name = $"{folder}/{EurocFiles.Table}";
        if (!dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing.");
        }

        bool isDescribed =
            !folder.EndsWith(EurocFiles.States, StringComparison.Ordinal) && !folder.EndsWith(EurocFiles.Gnss, StringComparison.Ordinal);
        if (isDescribed && !dataset.Has($"{folder}/{EurocFiles.Sensor}"))
        {
            yield return new SessionProblem($"{folder}/{EurocFiles.Sensor}", null, "it is missing.");
        }

        long before = long.MinValue;
        foreach ((int number, string text) in dataset.Lines(name))
        {
            string[] words = text.Split(',');
            string? problem;
            if (number == 1)
            {
                problem = text == columns ? null : $"it is not '{columns}'.";
            }
            else if (!long.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out long time) || time <= before)
            {
                problem = "its time is no number, or not after that of the line before.";
            }
            else
            {
                before = time;
                problem = problemOf(words);
            }

            if (problem is not null)
            {
                yield return new SessionProblem(name, number, problem);
            }
        }
    }

    private static string? ImageProblem(DatasetContent dataset, string camera, string[] words, HashSet<string> listed) =>
        words.Length != 2 || !words[1].StartsWith(words[0] + ".", StringComparison.Ordinal) ? "it is not a time and the image of that name."
        : !dataset.Has($"{camera}/data/{words[1]}") ? $"the image '{words[1]}' is missing."
        : listed.Add($"{camera}/data/{words[1]}") ? null
        : $"the image '{words[1]}' was listed before.";

    private static string? ImuProblem(string[] words) =>
        Numbers.Parse(words.Skip(1)) is { Length: ImuNumbers } ? null : $"it has not {ImuNumbers} numbers after its time.";

    private static string? GnssProblem(string[] words) =>
        Numbers.Parse(words.Skip(1)) is { Length: ImuNumbers } numbers && Math.Abs(numbers[0]) <= 90 && Math.Abs(numbers[1]) <= 180
            ? null
            : $"it has not the {ImuNumbers} numbers of a place on Earth and a velocity after its time.";

    private static string? StateProblem(string[] words)
    {
        bool areBiasesUnknown = words.Length == StateNumbers + 1 && words.Skip(FirstBias + 1).All(word => word == "nan");
        double[]? numbers = Numbers.Parse(areBiasesUnknown ? words.Skip(1).Take(FirstBias) : words.Skip(1));
        return numbers is null || numbers.Length != (areBiasesUnknown ? FirstBias : StateNumbers)
                ? $"it has not {StateNumbers} numbers after its time."
            : Math.Abs(numbers.Skip(FirstOfQuaternion).Take(Quaternion).Sum(part => part * part) - 1) > LengthTolerance
                ? "its quaternion is not of length 1."
            : null;
    }
}
