using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>
/// Checks OpenLABEL datasets line by line: the head with the camera, the frames with their images, and the objects with the frames in which
/// they occur.
/// </summary>
internal sealed class OpenLabelCheck
{
    private const string BetweenFramesAndObjects = "},";
    private const string End = "}}}";

    private readonly DatasetContent _dataset;
    private readonly string _name;
    private readonly string _images;
    private readonly Dictionary<int, FrameIntervals> _seen = [];
    private readonly FrameIntervals _frames = new();
    private readonly HashSet<int> _listed = [];
    private readonly Dictionary<string, string> _actions = [];
    private readonly Dictionary<string, FrameIntervals> _seenActions = [];
    private ImageSize? _size;
    private int _count;

    private OpenLabelCheck(DatasetContent dataset, string sequence)
    {
        _dataset = dataset;
        _name = $"labels/{sequence}.json";
        _images = $"images/{sequence}";
    }

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset.Splits.SelectMany(split =>
        {
            string[] sequences = [.. dataset.Folders($"images/{split}").Select(folder => folder["images/".Length..])];
            return sequences
                .SelectMany(sequence =>
                {
                    dataset.Found(split, dataset.Files($"images/{sequence}").Count);
                    return new OpenLabelCheck(dataset, sequence).Problems();
                })
                .Concat(LabelFiles.Strays(dataset, $"labels/{split}", sequences.Select(sequence => Path.GetFileName(sequence))));
        });

    private IEnumerable<SessionProblem> Problems()
    {
        if (!_dataset.Has(_name))
        {
            yield return new SessionProblem(_name, null, "it is missing, but its images exist.");
            yield break;
        }

        Func<string, string?> problemOf = HeadProblem;
        string last = "";
        foreach ((int number, string text) in _dataset.Lines(_name))
        {
            string? problem =
                last == End ? "a line follows the last."
                : text == End ? null
                : text == BetweenFramesAndObjects ? null
                : problemOf(text);
            if (problem is not null)
            {
                yield return new SessionProblem(_name, number, problem);
            }

            problemOf =
                number == 1 ? FrameProblem
                : text == BetweenFramesAndObjects ? MiddleProblem
                : last == BetweenFramesAndObjects ? ObjectProblem
                : problemOf;
            last = text;
        }

        if (last != End)
        {
            yield return new SessionProblem(_name, null, $"it is cut off: a line '{End}' must end it.");
        }
        else if (_dataset.Files(_images).Count is var images && images != _count)
        {
            yield return new SessionProblem(_name, null, $"it has {_count} frames, but {_images} has {images} images.");
        }
        else if (
            _actions
                .Keys.Union(_seenActions.Keys)
                .FirstOrDefault(id => _actions.GetValueOrDefault(id) != $"{_seenActions.GetValueOrDefault(id)}") is
            { } other
        )
        {
            yield return new SessionProblem(_name, null, $"action {other} is not in the frames of its frame_intervals.");
        }
        else if (_seen.Keys.FirstOrDefault(id => !_listed.Contains(id)) is var lost and > 0)
        {
            yield return new SessionProblem(_name, null, $"object {lost} is in frames, but not in the list of objects.");
        }
    }

    private string? HeadProblem(string text) =>
        FrameLines.ProblemOf(
            text + End,
            document =>
            {
                JsonFields head = document.Fields("openlabel");
                JsonFields camera = head.Fields("streams")
                    .Fields(OpenLabelStream.Camera)
                    .Fields("stream_properties")
                    .Fields("intrinsics_pinhole");
                double[] matrix = camera.Numbers("camera_matrix", 12);
                _size = camera.Checked(() => new ImageSize(camera.Integer("width_px"), camera.Integer("height_px")));
                JsonFields systems = head.Fields("coordinate_systems");
                if (head.Has("actions"))
                {
                    JsonFields actions = head.Fields("actions");
                    foreach (string id in actions.Names)
                    {
                        _actions[id] = actions.Fields(id).RawText("frame_intervals");
                        if (actions.Fields(id).Text("name").Length == 0 || actions.Fields(id).Text("type").Length == 0)
                        {
                            return $"action {id} has no name or no type.";
                        }
                    }
                }

                return head.Fields("metadata").Text("schema_version") != OpenLabelStream.SchemaVersion
                        ? $"schema_version is not {OpenLabelStream.SchemaVersion}."
                    : systems.Fields(OpenLabelStream.World).Text("parent").Length > 0
                    || systems.Names.Any(system =>
                        system != OpenLabelStream.World && systems.Fields(system).Text("parent") != OpenLabelStream.World
                    )
                        ? $"the coordinate systems are not {OpenLabelStream.World} and others within it."
                    : !(matrix[0] > 0 && matrix[5] > 0)
                    || !matrix.AsSpan(8).SequenceEqual([0, 0, 1, 0])
                    || matrix[1] != 0
                    || matrix[3] != 0
                    || matrix[4] != 0
                    || matrix[7] != 0
                        ? "camera_matrix is not the matrix of a camera."
                    : null;
            }
        );

    private string? FrameProblem(string text) =>
        FrameLines.ProblemOf(
            "{" + Trimmed(text) + "}",
            document =>
            {
                if (document.Names.ToArray() is not [var key] || key != Numbers.Text(_count))
                {
                    return $"it is not frame {_count}, which must follow.";
                }

                _frames.Add(_count++);
                JsonFields frame = document.Fields(key);
                string image = frame.Fields("frame_properties").Fields("streams").Fields(OpenLabelStream.Camera).Text("uri");
                JsonFields objects = frame.Fields("objects");
                foreach (string id in frame.Has("actions") ? frame.Fields("actions").Names : [])
                {
                    _seenActions.TryAdd(id, new FrameIntervals());
                    _seenActions[id].Add(_count - 1);
                }

                foreach (string id in objects.Names)
                {
                    if (!int.TryParse(id, out int number) || number < 1)
                    {
                        return $"'{id}' is not the number of an object.";
                    }

                    _seen.TryAdd(number, new FrameIntervals());
                    _seen[number].Add(_count - 1);
                }

                return Path.GetDirectoryName(image)?.Replace('\\', '/') != _images || !_dataset.Has(image)
                        ? $"its image '{image}' is missing."
                    : _dataset.Header(image) is { } header && _size is { } size && header.Size != size
                        ? $"its image is {header.Size.Width} x {header.Size.Height}, not {size.Width} x {size.Height}."
                    : OpenLabelData.TransformProblem(frame.Fields("frame_properties").Fields("transforms"))
                        ?? objects.Names.Select(id => DataProblem(objects.Fields(id), id)).FirstOrDefault(problem => problem is not null);
            }
        );

    private string? DataProblem(JsonFields item, string id) =>
        OpenLabelData.Problem(item.Fields("object_data"), _size, _dataset.Options.Boxes) is { } problem ? $"object {id}: {problem}" : null;

    private string? MiddleProblem(string text) =>
        FrameLines.ProblemOf(
            "{" + text + "}}",
            document =>
                document.RawText("frame_intervals") != _frames.ToString() ? $"frame_intervals is not {_frames}."
                : document.Fields("contexts").Names.Any() ? null
                : "it has no contexts."
        );

    private string? ObjectProblem(string text) =>
        text.Length == 0 && _seen.Count == 0 ? null : FrameLines.ProblemOf("{" + Trimmed(text) + "}", ListedProblem);

    private string? ListedProblem(JsonFields document)
    {
        if (
            document.Names.ToArray() is not [var key]
            || !int.TryParse(key, out int id)
            || !_seen.TryGetValue(id, out FrameIntervals? frames)
        )
        {
            return "it is not an object of a frame.";
        }

        JsonFields item = document.Fields(key);
        return !_listed.Add(id) ? $"object {id} occurs twice."
            : item.Text("name").Length == 0 || item.Text("type").Length == 0 ? $"object {id} has no name or no type."
            : item.RawText("frame_intervals") != frames.ToString()
                ? $"frame_intervals of object {id} is not {frames}, the frames that have it."
            : null;
    }

    private static string Trimmed(string text) => text.EndsWith(',') ? text[..^1] : text;
}
