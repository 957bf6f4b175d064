using System.Text.Json;
using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// Checks OpenLane datasets: every listed image has labels, the matrices are a camera's, and projected points fall on their pixels.
/// </summary>
internal static class OpenLaneCheck
{
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        Dictionary<string, int> images = Below(dataset, "images").ToDictionary(name => name, _ => 1);
        HashSet<string> stems = [.. images.Keys.Select(LabelsOf)];
        return SplitLists
            .Problems(dataset, split => $"{split}.txt", images)
            .Concat(
                images.Keys.SelectMany(image =>
                    Problem(dataset, image) is { } problem
                        ? [new SessionProblem(LabelsOf(image), null, problem)]
                        : Array.Empty<SessionProblem>()
                )
            )
            .Concat(
                Below(dataset, "lane3d")
                    .Select(name => "lane3d/" + name)
                    .Where(name => !stems.Contains(name))
                    .Select(name => new SessionProblem(name, null, "its image is missing."))
            );
    }

    private static string LabelsOf(string image) => "lane3d/" + Path.ChangeExtension(image, ".json").Replace('\\', '/');

    /// <summary>The files split/segment/frame below a folder, without the folder's name.</summary>
    private static IEnumerable<string> Below(DatasetContent dataset, string folder) =>
        dataset.Folders(folder).SelectMany(dataset.Folders).SelectMany(dataset.Files).Select(name => name[(folder.Length + 1)..]);

    private static string? Problem(DatasetContent dataset, string image)
    {
        string name = LabelsOf(image);
        if (!dataset.Has(name))
        {
            return "it is missing, but its image exists.";
        }

        try
        {
            using JsonDocument document = JsonInput.Read(dataset.PathOf(name));
            return Problem(new JsonFields(document.RootElement), image, dataset.Header("images/" + image)?.Size);
        }
        catch (JsonException e)
        {
            return JsonFault.InText(e);
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }

    private static string? Problem(JsonFields frame, string image, ImageSize? size)
    {
        double[][] intrinsic = frame.Rows("intrinsic", 3);
        double[][] extrinsic = frame.Rows("extrinsic", 4);
        if (frame.Text("file_path") != image)
        {
            return $"file_path is not '{image}'.";
        }

        return !IsCamera(intrinsic) ? "intrinsic is not the matrix of a camera."
            : !IsMotion(extrinsic) ? "extrinsic is not a rotation and a displacement."
            : !(extrinsic[2][3] > 0) ? "extrinsic puts the camera below the road."
            : size is not { } known ? null
            : frame
                .List("lane_lines")
                .Select(
                    (line, index) => OpenLaneLine.Problem(line, intrinsic, known) is { } problem ? $"lane_lines[{index}]: {problem}" : null
                )
                .FirstOrDefault(problem => problem is not null);
    }

    /// <summary>fx 0 cx, 0 fy cy, 0 0 1.</summary>
    private static bool IsCamera(double[][] k) =>
        k.Length == 3 && k[0][0] > 0 && k[1][1] > 0 && k[0][1] == 0 && k[1][0] == 0 && k[2].SequenceEqual([0, 0, 1]);

    private static bool IsMotion(double[][] m)
    {
        // Matrix elements have nine decimals.
        const double rounding = 0.00000001;
        return m.Length == 4
            && m[3].SequenceEqual([0, 0, 0, 1])
            && Enumerable.Range(0, 3).All(i => Enumerable.Range(0, 3).All(j => Math.Abs(Dot(m[i], m[j]) - (i == j ? 1 : 0)) < rounding))
            && Determinant(m) > 0;
    }

    private static double Dot(double[] a, double[] b) => (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);

    private static double Determinant(double[][] m) =>
        (m[0][0] * ((m[1][1] * m[2][2]) - (m[1][2] * m[2][1])))
        - (m[0][1] * ((m[1][0] * m[2][2]) - (m[1][2] * m[2][0])))
        + (m[0][2] * ((m[1][0] * m[2][1]) - (m[1][1] * m[2][0])));
}
