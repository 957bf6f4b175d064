using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>
/// Checks OpenLane-V2 datasets: every listed frame has both files and its image, every image is listed, lanes are in range and the topology
/// fits the lists.
/// </summary>
internal static class OpenLaneV2Check
{
    private const string Segments = "-ls.json";
    private const string Plain = ".json";

    /// <summary>Metres have four decimals, elements of matrices nine, pixels three.</summary>
    private const double RoundingMetres = 0.0002;
    private const double RoundingAxis = 0.00000001;
    private const double RoundingPixels = 0.002;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        HashSet<string> listed = [];
        var problems = new List<SessionProblem>();
        try
        {
            using JsonDocument document = JsonInput.Read(dataset.PathOf(OpenLaneV2Writer.Index));
            var index = new JsonFields(document.RootElement);
            foreach (string split in index.Names)
            {
                JsonFields segments = index.Fields(split);
                foreach (string segment in segments.Names)
                {
                    string[] frames = segments.Texts(segment);
                    dataset.Found(split, frames.Length);
                    listed.UnionWith(frames.Select(frame => $"{split}/{segment}/info/{frame}"));
                }
            }
        }
        catch (JsonException e)
        {
            problems.Add(new SessionProblem(OpenLaneV2Writer.Index, null, JsonFault.InText(e)));
        }
        catch (Exception e) when (e is DatasetFormatException or IOException)
        {
            problems.Add(new SessionProblem(OpenLaneV2Writer.Index, null, e.Message));
        }

        if (problems.Count > 0)
        {
            return problems;
        }

        HashSet<string> images = [];
        foreach (string frame in listed.Order(StringComparer.Ordinal))
        {
            foreach (string name in (string[])[frame, frame[..^Math.Min(Plain.Length, frame.Length)] + Segments])
            {
                if (Problem(dataset, name, images) is { } problem)
                {
                    problems.Add(new SessionProblem(name, null, problem));
                }
            }
        }

        problems.AddRange(
            dataset
                .Splits.SelectMany(dataset.Folders)
                .SelectMany(segment => dataset.Files(segment + "/info"))
                .Where(name => !name.EndsWith(Segments, StringComparison.Ordinal) && !listed.Contains(name))
                .Select(name => new SessionProblem(name, null, $"it is not in {OpenLaneV2Writer.Index}."))
        );
        problems.AddRange(
            dataset
                .Splits.SelectMany(dataset.Folders)
                .SelectMany(segment => dataset.Folders(segment + "/image"))
                .SelectMany(dataset.Files)
                .Where(name => !images.Contains(name))
                .Select(name => new SessionProblem(name, null, "no frame names it."))
        );
        return problems;
    }

    private static string? Problem(DatasetContent dataset, string name, HashSet<string> images)
    {
        if (!dataset.Has(name))
        {
            return $"it is missing, but {OpenLaneV2Writer.Index} lists its frame.";
        }

        try
        {
            using JsonDocument document = JsonInput.Read(dataset.PathOf(name));
            var frame = new JsonFields(document.RootElement);
            if (!name.EndsWith($"/info/{frame.LongInteger("timestamp")}{Suffix(name)}", StringComparison.Ordinal))
            {
                return "timestamp is not that of its name.";
            }

            JsonFields sensors = frame.Fields("sensor");
            foreach (JsonFields sensor in sensors.Names.Select(sensors.Fields))
            {
                string image = sensor.Text("image_path");
                images.Add(image);
                if (!dataset.Has(image))
                {
                    return $"its image '{image}' is missing.";
                }

                if (!IsRotation(sensor.Fields("extrinsic").Rows("rotation", 3)))
                {
                    return "extrinsic is not a rotation and a displacement.";
                }

                if (
                    dataset.Header(image)?.Size is { } size
                    && ElementProblem(frame.Fields("annotation"), size.Width, size.Height) is { } wrong
                )
                {
                    return wrong;
                }
            }

            return !IsRotation(frame.Fields("pose").Rows("rotation", 3)) ? "pose is not a rotation and a displacement."
                : Suffix(name) == Segments ? SegmentProblem(frame.Fields("annotation"))
                : LaneProblem(frame.Fields("annotation"), "lane_centerline", ["points"], "topology_lclc", "topology_lcte");
        }
        catch (JsonException e)
        {
            return JsonFault.InText(e);
        }
        catch (Exception e) when (e is DatasetFormatException or IOException)
        {
            return e.Message;
        }
    }

    private static string Suffix(string name) => name.EndsWith(Segments, StringComparison.Ordinal) ? Segments : Plain;

    private static string? SegmentProblem(JsonFields annotation)
    {
        IReadOnlyList<JsonFields> lanes = annotation.List("lane_segment");
        string[] types = ["left_laneline_type", "right_laneline_type"];
        if (lanes.Any(lane => types.Any(type => lane.Integer(type) is < PaintedEdges.None or > PaintedEdges.Dashed)))
        {
            return "the type of a lane line is not 0, 1 or 2.";
        }

        foreach (JsonFields area in annotation.List("area"))
        {
            if (area.Integer("category") is < MapAreas.Crossing or > MapAreas.Boundary || !IsInRange(area.Rows("points", 3)))
            {
                return "an area has an unknown category or points out of range.";
            }
        }

        return LaneProblem(annotation, "lane_segment", ["centerline", "left_laneline", "right_laneline"], "topology_lsls", "topology_lste");
    }

    private static string? LaneProblem(JsonFields annotation, string list, string[] lines, string lanesToLanes, string lanesToElements)
    {
        IReadOnlyList<JsonFields> lanes = annotation.List(list);
        for (int i = 0; i < lanes.Count; i++)
        {
            if (!IsInRange(lanes[i].Rows(lines[0], 3)) || lines.Any(line => lanes[i].Rows(line, 3).Length < 2))
            {
                return $"{list}[{i}] has points out of range, or fewer than two.";
            }
        }

        int elements = annotation.List("traffic_element").Count;
        return lanes.Select(lane => lane.LongInteger("id")).Distinct().Count() < lanes.Count ? $"two of {list} have the same id."
            : !IsTopology(annotation.Rows(lanesToLanes), lanes.Count, lanes.Count)
                ? $"{lanesToLanes} is not a matrix of 0 and 1 of its lanes."
            : !IsTopology(annotation.Rows(lanesToElements), lanes.Count, elements)
                ? $"{lanesToElements} is not a matrix of 0 and 1 of its lanes and elements."
            : null;
    }

    private static string? ElementProblem(JsonFields annotation, int width, int height)
    {
        IReadOnlyList<JsonFields> elements = annotation.List("traffic_element");
        for (int i = 0; i < elements.Count; i++)
        {
            double[][] box = elements[i].Rows("points", 2);
            if (
                elements[i].Integer("category") is not (TrafficElement.Light or TrafficElement.Sign)
                || elements[i].Integer("attribute") is < 0 or > TrafficElement.LastAttribute
            )
            {
                return $"traffic_element[{i}] has an unknown category or attribute.";
            }

            if (
                box.Length != 2
                || !(box[0][0] >= -RoundingPixels && box[0][1] >= -RoundingPixels && box[0][0] < box[1][0] && box[0][1] < box[1][1])
                || !(box[1][0] <= width + RoundingPixels && box[1][1] <= height + RoundingPixels)
            )
            {
                return $"traffic_element[{i}] does not lie in the image of {width} x {height}.";
            }
        }

        return null;
    }

    private static bool IsTopology(double[][] rows, int height, int width) =>
        rows.Length == height && rows.All(row => row.Length == width && row.All(value => value is 0 or 1));

    private static bool IsInRange(double[][] points) =>
        points.All(point =>
            Math.Abs(point[0]) <= VehicleRange.Ahead + RoundingMetres && Math.Abs(point[1]) <= VehicleRange.Aside + RoundingMetres
        );

    /// <summary>Whether the rows are orthogonal and of length 1, and the determinant is not -1.</summary>
    private static bool IsRotation(double[][] m) =>
        m.Length == 3
        && Enumerable.Range(0, 3).All(i => Enumerable.Range(0, 3).All(j => Math.Abs(Dot(m[i], m[j]) - (i == j ? 1 : 0)) < RoundingAxis))
        && Determinant(m) > 0;

    private static double Dot(double[] a, double[] b) => (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);

    private static double Determinant(double[][] m) =>
        (m[0][0] * ((m[1][1] * m[2][2]) - (m[1][2] * m[2][1])))
        - (m[0][1] * ((m[1][0] * m[2][2]) - (m[1][2] * m[2][0])))
        + (m[0][2] * ((m[1][0] * m[2][1]) - (m[1][1] * m[2][0])));
}
