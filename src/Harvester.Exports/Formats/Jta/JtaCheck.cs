using System.Globalization;
using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Jta;

/// <summary>Checks JTA datasets: rows are joints of frames that exist, and positions project to pixels.</summary>
internal static class JtaCheck
{
    private const int Columns = 10;

    /// <summary>Tolerance of projections, pixels: positions are rounded to 0.1 mm, which is less than this at any depth in use.</summary>
    private const double RoundingPixels = 0.5;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset.Folders("frames").SelectMany(split => dataset.Folders(split)).SelectMany(folder => ProblemsOf(dataset, folder));

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, string folder)
    {
        string sequence = folder["frames/".Length..];
        HashSet<string> frames = [.. dataset.Files(folder).Select(file => Path.GetFileNameWithoutExtension(file))];
        dataset.Found(sequence.Split('/')[0], frames.Count);
        string name = $"annotations/{sequence}.json";
        string camera = $"cameras/{sequence}.json";
        if (!dataset.Has(name) || !dataset.Has(camera))
        {
            yield return new SessionProblem(dataset.Has(name) ? camera : name, null, "it is missing.");
            yield break;
        }

        (double[]? k, string? damage) = Intrinsics(dataset, camera);
        if (k is null)
        {
            yield return new SessionProblem(camera, null, damage!);
            yield break;
        }

        foreach ((int number, string text) in dataset.Lines(name))
        {
            if (text is not ("[" or "]" or "") && Problem(text, frames, k) is { } problem)
            {
                yield return new SessionProblem(name, number, problem);
            }
        }
    }

    private static (double[]? Intrinsics, string? Damage) Intrinsics(DatasetContent dataset, string camera)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(dataset.PathOf(camera));
            var fields = new JsonFields(document.RootElement);
            return ([fields.Number("fx"), fields.Number("fy"), fields.Number("cx"), fields.Number("cy")], null);
        }
        catch (JsonException e)
        {
            return (null, JsonFault.InText(e));
        }
        catch (DatasetFormatException e)
        {
            return (null, e.Message);
        }
    }

    private static string? Problem(string text, HashSet<string> frames, double[] k)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse("{\"rows\":[" + text.TrimEnd(',') + "]}");
            return new JsonFields(document.RootElement)
                .Rows("rows", Columns)
                .Select(row => Problem(row, frames, k))
                .FirstOrDefault(problem => problem is not null);
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

    private static string? Problem(double[] row, HashSet<string> frames, double[] k)
    {
        double depth = row[7];
        double off = Math.Max(Math.Abs(k[2] + (k[0] * row[5] / depth) - row[3]), Math.Abs(k[3] + (k[1] * row[6] / depth) - row[4]));
        return !frames.Contains(row[0].ToString(CultureInfo.InvariantCulture))
                ? FormattableString.Invariant($"frame {row[0]} has no image.")
            : row[1] is < 1 or > ushort.MaxValue ? FormattableString.Invariant($"the person's number is {row[1]}; it must be 1 to 65535.")
            : row[2] is < 0 or >= Skeleton.Count ? FormattableString.Invariant($"the joint is {row[2]}; it must be 0 to 21.")
            : row[8] is not (0 or 1) || row[9] is not (0 or 1) ? "a flag is not 0 or 1."
            : !(depth > 0 && off <= RoundingPixels * Math.Max(1, 1 / depth)) ? "a position does not project to its pixel."
            : null;
    }
}
