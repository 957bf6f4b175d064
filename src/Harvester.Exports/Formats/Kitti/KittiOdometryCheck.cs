using Harvester.Exports.Checks;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks KITTI odometry datasets: images, times, poses, calibration, points and labels of every sequence.</summary>
internal static class KittiOdometryCheck
{
    private const int PoseNumbers = 12;
    private const int BytesPerPoint = 16;
    private const int BytesPerLabel = 4;
    private const double RotationTolerance = 1e-6;
    private const string Sequences = "sequences";
    private const string Transform = "Tr:";

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        string[] sequences = [.. dataset.Folders(Sequences).Select(folder => Path.GetFileName(folder))];
        Dictionary<string, int> frames = sequences.ToDictionary(
            sequence => sequence,
            sequence =>
                Enumerable
                    .Range(0, KittiRig.Cameras)
                    .Sum(slot => dataset.Files($"{KittiOdometryWriter.FolderOf(sequence)}/image_{slot}").Count)
        );
        return sequences
            .SelectMany(sequence => ProblemsOf(dataset, sequence))
            .Concat(SplitLists.Problems(dataset, split => $"ImageSets/{split}.txt", frames));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, string sequence)
    {
        string folder = KittiOdometryWriter.FolderOf(sequence);
        string images = $"{folder}/image_{KittiRig.Reference}";
        string[] names = [.. dataset.Files(images).Select(image => Path.GetFileNameWithoutExtension(image))];
        for (int number = 0; number < names.Length; number++)
        {
            if (names[number] != $"{number:D6}")
            {
                yield return new SessionProblem(images, null, $"image {number:D6} is missing.");
                yield break;
            }
        }

        foreach (
            SessionProblem problem in TimeProblems(dataset, $"{folder}/times.txt", names.Length)
                .Concat(PoseProblems(dataset, $"poses/{sequence}.txt", names.Length))
                .Concat(PoseProblems(dataset, $"{folder}/poses.txt", names.Length))
                .Concat(CalibrationProblems(dataset, $"{folder}/calib.txt"))
                .Concat(names.SelectMany(name => PointProblems(dataset, folder, name)))
                .Concat(
                    Enumerable
                        .Range(0, names.Length)
                        .SelectMany(number => KittiOxtsCheck.Problems(dataset, $"{folder}/oxts/data/{number:D10}.txt"))
                )
        )
        {
            yield return problem;
        }
    }

    private static IEnumerable<SessionProblem> TimeProblems(DatasetContent dataset, string name, int count)
    {
        double last = double.NegativeInfinity;
        int lines = 0;
        foreach ((int number, string text) in dataset.Lines(name))
        {
            lines++;
            if (Numbers.Parse([text]) is not [var time] || time <= last || (number == 1 && time != 0))
            {
                yield return new SessionProblem(name, number, "it is not a time after the one before, from 0.");
                yield break;
            }

            last = time;
        }

        if (lines != count)
        {
            yield return new SessionProblem(name, null, $"it has {lines} lines for {count} images.");
        }
    }

    private static IEnumerable<SessionProblem> PoseProblems(DatasetContent dataset, string name, int count)
    {
        int lines = 0;
        foreach ((int number, string text) in dataset.Lines(name))
        {
            lines++;
            if (Numbers.Parse(text.Split(' ')) is not { Length: PoseNumbers } pose)
            {
                yield return new SessionProblem(name, number, $"it does not have {PoseNumbers} numbers.");
            }
            else if (!IsRotation(pose))
            {
                yield return new SessionProblem(name, number, "its first three columns are no rotation.");
            }
        }

        if (lines != count)
        {
            yield return new SessionProblem(name, null, $"it has {lines} lines for {count} images.");
        }
    }

    private static bool IsRotation(double[] pose)
    {
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                double product = Enumerable.Range(0, 3).Sum(k => pose[(4 * k) + i] * pose[(4 * k) + j]);
                if (Math.Abs(product - (i == j ? 1 : 0)) > RotationTolerance)
                {
                    return false;
                }
            }
        }

        return true;
    }

    private static IEnumerable<SessionProblem> CalibrationProblems(DatasetContent dataset, string name)
    {
        HashSet<string> missing = [.. Enumerable.Range(0, KittiRig.Cameras).Select(slot => $"P{slot}:"), Transform];
        foreach ((int number, string text) in dataset.Lines(name))
        {
            string[] words = text.Split(' ');
            if (!missing.Remove(words[0]) || Numbers.Parse(words.Skip(1)) is not { Length: PoseNumbers })
            {
                yield return new SessionProblem(name, number, $"it is not one of P0 to P3 and Tr, once, with {PoseNumbers} numbers.");
            }
        }

        foreach (string matrix in missing)
        {
            yield return new SessionProblem(name, null, $"{matrix.TrimEnd(':')} is missing.");
        }
    }

    private static IEnumerable<SessionProblem> PointProblems(DatasetContent dataset, string folder, string frame)
    {
        string points = $"{folder}/velodyne/{frame}.bin";
        string labels = $"{folder}/labels/{frame}.label";
        if (!dataset.Has(points) && !dataset.Has(labels))
        {
            yield break;
        }

        if (
            !dataset.Has(points)
            || !dataset.Has(labels)
            || new FileInfo(dataset.PathOf(points)).Length / BytesPerPoint * BytesPerLabel != new FileInfo(dataset.PathOf(labels)).Length
            || new FileInfo(dataset.PathOf(points)).Length % BytesPerPoint != 0
        )
        {
            yield return new SessionProblem(labels, null, "it does not have four bytes for each point of its scan.");
            yield break;
        }

        byte[] bytes = InputFile.ReadAllBytes(dataset.PathOf(labels), LidarFile.MaxPoints * BytesPerLabel);
        for (int at = 0; at < bytes.Length; at += BytesPerLabel)
        {
            uint kind = SemanticKittiLabels.ClassOf(BitConverter.ToUInt32(bytes, at));
            if (!SemanticKittiLabels.Classes.Contains(kind))
            {
                yield return new SessionProblem(
                    labels,
                    null,
                    $"point {at / BytesPerLabel} has the class {kind}, which is not in SemanticKITTI."
                );
                yield break;
            }
        }
    }
}
