using Harvester.Exports.Checks;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Bdd100K;

/// <summary>Checks BDD100K datasets: frames with their images and attributes, boxes of objects, and lines of lane markings.</summary>
internal sealed class Bdd100KCheck
{
    private const double RoundingPixels = 0.002;

    private readonly DatasetContent _dataset;
    private readonly HashSet<string> _named = new(StringComparer.Ordinal);
    private readonly HashSet<(string Video, int Frame)> _places = [];

    private Bdd100KCheck(DatasetContent dataset) => _dataset = dataset;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var check = new Bdd100KCheck(dataset);
        return dataset.Splits.SelectMany(check.SplitProblems);
    }

    private IEnumerable<SessionProblem> SplitProblems(string split)
    {
        string objects = Bdd100KWriter.ObjectsOf(split);
        string lanes = Bdd100KWriter.LanesOf(split);
        var withLanes = new HashSet<string>(StringComparer.Ordinal);
        return FrameLines
            .ListProblems(_dataset, objects, frame => ObjectsProblem(frame, split))
            .Concat(
                _dataset
                    .Files(Bdd100KWriter.Images + split)
                    .Where(image => !_named.Contains(Path.GetFileName(image)))
                    .Select(image => new SessionProblem(image, null, $"it is not in {objects}."))
            )
            .Concat(!_dataset.Has(lanes) ? [] : FrameLines.ListProblems(_dataset, lanes, frame => LanesProblem(frame, withLanes)));
    }

    private string? ObjectsProblem(JsonFields frame, string split)
    {
        _dataset.Found(split);
        string name = frame.Text("name");
        string image = $"{Bdd100KWriter.Images}{split}/{name}";
        if (!_dataset.Has(image) || !_named.Add(name))
        {
            return $"'{name}' is not in {Bdd100KWriter.Images}{split}, or occurs twice.";
        }

        ImageSize size = SizeOf(frame);
        JsonFields attributes = frame.Fields("attributes");
        var ids = new HashSet<string>(StringComparer.Ordinal);
        return _dataset.Header(image) is { } header && header.Size != size
                ? $"its image is {header.Size.Width} x {header.Size.Height}, not {size.Width} x {size.Height}."
            : !_places.Add((frame.Text("videoName"), frame.Integer("frameIndex"))) ? "its videoName and frameIndex occur twice."
            : !Bdd100KClasses.Weathers.Contains(attributes.Text("weather")) ? $"weather '{attributes.Text("weather")}' is unknown."
            : !Bdd100KClasses.Times.Contains(attributes.Text("timeofday")) ? $"timeofday '{attributes.Text("timeofday")}' is unknown."
            : frame.List("labels").Select(label => LabelProblem(label, size, ids)).FirstOrDefault(problem => problem is not null);
    }

    private static ImageSize SizeOf(JsonFields frame)
    {
        JsonFields size = frame.Fields("size");
        return size.Checked(() => new ImageSize(size.Integer("width"), size.Integer("height")));
    }

    private static string? LabelProblem(JsonFields label, ImageSize size, HashSet<string> ids)
    {
        string id = label.Text("id");
        JsonFields attributes = label.Fields("attributes");
        JsonFields sides = label.Fields("box2d");

        // The last pixel belongs to the box.
        var box = new Box2D(sides.Number("x1"), sides.Number("y1"), sides.Number("x2") + 1, sides.Number("y2") + 1);
        string? problem =
            !ids.Add(id) ? "its id occurs twice."
            : !Bdd100KClasses.Names.Contains(label.Text("category")) ? $"category '{label.Text("category")}' is unknown."
            : !Bdd100KClasses.Lights.Contains(attributes.Text("trafficLightColor")) ? "trafficLightColor has an unknown value."
            : attributes.Boolean("crowd") && (attributes.Boolean("occluded") || attributes.Boolean("truncated"))
                ? "it is an ignore region (crowd), but has other flags."
            : !(box.Width > 0 && box.Height > 0 && size.Bounds.Contains(box, RoundingPixels))
                ? $"its box does not lie in the image of {size.Width} x {size.Height}, or has no area."
            : null;
        return problem is null ? null : $"label {id}: {problem}";
    }

    private string? LanesProblem(JsonFields frame, HashSet<string> withLanes)
    {
        string name = frame.Text("name");
        ImageSize size = SizeOf(frame);
        return !_named.Contains(name) || !withLanes.Add(name)
            ? $"'{name}' has no objects' frame, or occurs twice."
            : frame
                .List("labels")
                .Select((label, i) => LaneProblem(label, size) is { } problem ? $"label {i}: {problem}" : null)
                .FirstOrDefault(problem => problem is not null);
    }

    private static string? LaneProblem(JsonFields label, ImageSize size)
    {
        JsonFields attributes = label.Fields("attributes");
        return !Bdd100KClasses.Markings.Contains(label.Text("category")) ? $"category '{label.Text("category")}' is unknown."
            : attributes.Text("laneStyle") is not ("solid" or "dashed") ? "laneStyle is not solid or dashed."
            : attributes.Text("laneDirection") is not ("parallel" or "vertical") ? "laneDirection is not parallel or vertical."
            : label.List("poly2d").Select(line => LineProblem(line, size)).FirstOrDefault(problem => problem is not null);
    }

    private static string? LineProblem(JsonFields line, ImageSize size)
    {
        Vector2D[] points = line.Points("vertices");
        return line.Boolean("closed") ? "its line is closed."
            : points.Length < 2 || line.Text("types") != new string('L', points.Length)
                ? "types is not an L for each of two or more points."
            : points.Any(point => !size.Bounds.Contains(new Box2D(point.X, point.Y, point.X, point.Y), RoundingPixels))
                ? $"a point does not lie in the image of {size.Width} x {size.Height}."
            : null;
    }
}
