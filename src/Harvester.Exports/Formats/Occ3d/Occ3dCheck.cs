using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>
/// Checks Occ3D datasets: annotations.json names every moment once, in chains, with images and voxels that are there, and each scene is in
/// one split.
/// </summary>
internal sealed class Occ3dCheck
{
    private readonly DatasetContent _dataset;
    private readonly Dictionary<string, int> _framesOfScenes = new(StringComparer.Ordinal);
    private readonly HashSet<string> _listed = new(StringComparer.Ordinal);
    private readonly HashSet<string> _splits = new(StringComparer.Ordinal);
    private string? _scene;
    private (string Token, string Next)? _before;

    private Occ3dCheck(DatasetContent dataset) => _dataset = dataset;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) => new Occ3dCheck(dataset).All();

    /// <summary>The problems of each line; after one that is no part of the file, what follows cannot be judged.</summary>
    private IEnumerable<SessionProblem> All()
    {
        if (!_dataset.Has(Occ3dFiles.Annotations))
        {
            yield return new SessionProblem(Occ3dFiles.Annotations, null, "it is missing.");
            yield break;
        }

        string before = "";
        int depth = 0;
        int number = 0;
        foreach ((int line, string text) in _dataset.Lines(Occ3dFiles.Annotations))
        {
            number = line;
            bool isEnd = text.StartsWith('}');
            string? layout = LayoutProblem(line, text, before, depth);
            if (layout is not null)
            {
                yield return new SessionProblem(Occ3dFiles.Annotations, line, layout);
                yield break;
            }

            bool isScene = line > 1 && depth == 2 && text.EndsWith(":{", StringComparison.Ordinal);
            string? problem = isEnd
                ? EndProblem(ref depth)
                : Checked(() => line == 1 ? null : LineProblem(isScene ? text + "}" : text.TrimEnd(','), depth, isScene));
            depth +=
                line == 1 ? 2
                : isScene ? 1
                : 0;
            before = text;
            if (problem is not null)
            {
                yield return new SessionProblem(Occ3dFiles.Annotations, line, problem);
                if (isScene)
                {
                    yield break;
                }
            }
        }

        if (number == 0 || depth != 0)
        {
            yield return new SessionProblem(Occ3dFiles.Annotations, number, "the file ends too early.");
        }

        foreach (string scene in _framesOfScenes.Keys.Where(scene => !_listed.Contains(scene)))
        {
            yield return new SessionProblem(Occ3dFiles.Annotations, null, $"the scene '{scene}' is in no split.");
        }
    }

    /// <summary>Whether a line can follow another: a comma stands between fields, and none before the end of an object.</summary>
    private static string? LayoutProblem(int line, string text, string before, int depth) =>
        line == 1 && text != Occ3dFiles.Begin ? $"it is not '{Occ3dFiles.Begin}'."
        : line > 1 && depth == 0 ? "it follows the end of the file."
        : line > 1 && !before.EndsWith('{') && before.EndsWith(',') == text.StartsWith('}')
            ? "the comma before it is missing, or one too many."
        : null;

    private string? EndProblem(ref int depth)
    {
        depth--;
        (string Token, string Next)? last = _before;
        _before = null;
        return last is { Next.Length: > 0 } ? "the last moment before it has a next one." : null;
    }

    private string? LineProblem(string text, int depth, bool isScene)
    {
        using JsonDocument document = JsonInput.Parse($"{{{text}}}");
        var fields = new JsonFields(document.RootElement);
        if (fields.Names.ToArray() is not [var name])
        {
            return "it is not one field.";
        }

        switch (depth)
        {
            case 1:
                return SplitProblem(name, fields.Texts(name));
            case 2 when isScene:
                _scene = name;
                return _framesOfScenes.TryAdd(name, 0) ? null : $"the scene '{name}' occurs twice.";
            case 2:
                return "it is no scene.";
            default:
                return MomentProblem(name, fields.Fields(name));
        }
    }

    private string? SplitProblem(string field, string[] scenes)
    {
        if (_dataset.Splits.FirstOrDefault(split => Occ3dFiles.FieldOf(split) == field) is not { } name || !_splits.Add(name))
        {
            return $"'{field}' is no split of the export, or is listed twice.";
        }

        foreach (string scene in scenes)
        {
            if (!_framesOfScenes.TryGetValue(scene, out int frames))
            {
                return $"the scene '{scene}' is unknown.";
            }

            if (!_listed.Add(scene))
            {
                return $"the scene '{scene}' was listed before, here or in another split.";
            }

            _dataset.Found(name, frames);
        }

        return null;
    }

    private string? MomentProblem(string token, JsonFields moment)
    {
        string path = Occ3dFiles.LabelsOf(_scene!, token);
        JsonFields cameras = moment.Fields("camera_sensor");
        string[] names = [.. cameras.Names];
        (string Token, string Next)? before = _before;
        _before = (token, moment.Text("next"));
        _framesOfScenes[_scene!] += names.Length;
        return !(moment.Text("prev") == (before?.Token ?? "") && (before is null || before.Value.Next == token))
                ? "prev and next do not lead from the moment before it to this one and back."
            : !long.TryParse(moment.Text("timestamp"), out _) ? "its timestamp is no number."
            : names.Length == 0 ? "it has no camera."
            : PoseProblem(moment) is { } pose ? pose
            : names.Select(name => CameraProblem(cameras.Fields(name))).FirstOrDefault(static problem => problem is not null) is { } camera
                ? camera
            : moment.Text("gt_path") != path ? $"its gt_path is not '{path}'."
            : !_dataset.Has(path) ? $"its voxels '{path}' are missing."
            : LabelsProblem(path);
    }

    private string? CameraProblem(JsonFields camera)
    {
        string image = camera.Text("img_path");
        return !_dataset.Has(image) ? $"its image '{image}' is missing."
            : camera.Rows("intrinsic", 3) is not [[> 0, 0, _], [0, > 0, _], [0, 0, 1]] ? "its intrinsic is no camera matrix."
            : PoseProblem(camera, "extrinsic") ?? PoseProblem(camera);
    }

    private static string? PoseProblem(JsonFields record, string name = "ego_pose")
    {
        JsonFields pose = record.Fields(name);
        const double rounding = 1e-6;
        return
            pose.Numbers("translation", 3).Length == 3
            && Math.Abs(pose.Numbers("rotation", 4).Sum(static part => part * part) - 1) <= rounding
            ? null
            : $"the rotation of its {name} is no unit quaternion.";
    }

    private string? LabelsProblem(string path)
    {
        using FileStream file = InputFile.OpenRead(_dataset.PathOf(path));
        return Occ3dLabels.ProblemOf(file) is { } problem ? $"its voxels '{path}': {problem}" : null;
    }

    private static string? Checked(Func<string?> check)
    {
        try
        {
            return check();
        }
        catch (Exception e) when (e is DatasetFormatException or JsonException)
        {
            return JsonFault.InText(e);
        }
    }
}
