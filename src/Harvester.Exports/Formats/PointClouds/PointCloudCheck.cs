using System.Globalization;
using System.Text;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.PointClouds;

/// <summary>Checks point clouds: the table, and the header and length of every cloud.</summary>
internal static class PointCloudCheck
{
    private const int CloudColumns = 15;
    private const double RotationTolerance = 1e-6;

    /// <summary>Checks a dataset.</summary>
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, PointCloudKind kind)
    {
        var files = new HashSet<string>(StringComparer.Ordinal);
        return CloudProblems(dataset, kind, files).Concat(Strays(dataset, files));
    }

    private static IEnumerable<SessionProblem> CloudProblems(DatasetContent dataset, PointCloudKind kind, HashSet<string> files)
    {
        var frames = new HashSet<string>(StringComparer.Ordinal);
        foreach (
            (int number, string[] words, SessionProblem? problem) in Rows(
                dataset,
                PointCloudWriter.Clouds,
                PointCloudWriter.CloudColumns,
                CloudColumns
            )
        )
        {
            if ((problem ?? ProblemOf(dataset, kind, number, words)) is { } found)
            {
                yield return found;
            }
            else if (frames.Add(words[1]))
            {
                dataset.Found(words[2]);
            }

            files.Add(words[0]);
        }
    }

    private static SessionProblem? ProblemOf(DatasetContent dataset, PointCloudKind kind, int number, string[] words) =>
        !dataset.Splits.Contains(words[2]) ? new(PointCloudWriter.Clouds, number, $"it has the unknown split '{words[2]}'.")
        : !int.TryParse(words[7], NumberStyles.None, CultureInfo.InvariantCulture, out int points) || points > LidarFile.MaxPoints
            ? new(PointCloudWriter.Clouds, number, "its number of points is no number.")
        : Numbers.Parse(words.Skip(8)) is not { } pose || Math.Abs(pose.Skip(3).Sum(part => part * part) - 1) > RotationTolerance
            ? new(PointCloudWriter.Clouds, number, "its pose is no position and unit quaternion.")
        : !dataset.Has(words[0]) ? new(words[0], null, "it is missing.")
        : FileProblem(dataset, kind, words[0], points) is { } file ? new(words[0], null, file)
        : null;

    private static string? FileProblem(DatasetContent dataset, PointCloudKind kind, string name, int points)
    {
        byte[] header = Encoding.ASCII.GetBytes(kind.HeaderOf(points));
        int length = header.Length + (points * PointCloudKind.BytesPerPoint);
        if (!name.EndsWith(kind.Extension, StringComparison.Ordinal) || new FileInfo(dataset.PathOf(name)).Length != length)
        {
            return $"it does not have {length} bytes, as its {points} points need.";
        }

        return InputFile.ReadAllBytes(dataset.PathOf(name), length).AsSpan(0, header.Length).SequenceEqual(header)
            ? null
            : $"its header is not that of {points} points.";
    }

    private static IEnumerable<SessionProblem> Strays(DatasetContent dataset, HashSet<string> files) =>
        dataset
            .Folders(PointCloudWriter.Folder)
            .SelectMany(dataset.Files)
            .Where(name => !files.Contains(name))
            .Select(name => new SessionProblem(name, null, $"it is not in {PointCloudWriter.Clouds}."));

    private static IEnumerable<(int Number, string[] Words, SessionProblem? Problem)> Rows(
        DatasetContent dataset,
        string name,
        string header,
        int columns
    )
    {
        bool isFirst = true;
        foreach ((int number, string text) in dataset.Lines(name))
        {
            string[] words = text.Split(',');
            if (isFirst)
            {
                isFirst = false;
                if (text != header)
                {
                    yield return (number, words, new SessionProblem(name, number, $"it is not '{header}'."));
                }
            }
            else
            {
                yield return (
                    number,
                    words,
                    words.Length == columns
                        ? null
                        : new SessionProblem(name, number, $"it has {words.Length} columns instead of {columns}.")
                );
            }
        }

        if (isFirst)
        {
            yield return (0, [""], new SessionProblem(name, null, "it is missing."));
        }
    }
}
