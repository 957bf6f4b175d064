using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>The lane lines of exported datasets: the path of an image, and the points in it in pixels.</summary>
internal static class ExportedLines
{
    /// <summary>The formats that can be read.</summary>
    public static IReadOnlyDictionary<string, Func<string, IEnumerable<(string Image, Vector2D[] Points)>>> Readers { get; } =
        new SortedDictionary<string, Func<string, IEnumerable<(string Image, Vector2D[] Points)>>>
        {
            ["bdd100k"] = Bdd100K,
            ["culane"] = CuLane,
            ["openlabel"] = OpenLabel,
            ["openlane"] = OpenLane,
            ["tusimple"] = TuSimple,
        };

    private static IEnumerable<(string Image, Vector2D[] Points)> TuSimple(string folder)
    {
        foreach (string line in File.ReadLines(Directory.EnumerateFiles(folder, "label_data_*.json").Single()))
        {
            using JsonDocument frame = JsonDocument.Parse(line);
            double[] rows = Numbers(frame.RootElement.GetProperty("h_samples"));
            string image = Path.Combine(folder, frame.RootElement.GetProperty("raw_file").GetString()!);
            foreach (JsonElement lane in frame.RootElement.GetProperty("lanes").EnumerateArray())
            {
                // Whole columns, of which the middle counts; -2 is no point.
                IEnumerable<(double Column, double Row)> points = Numbers(lane).Zip(rows).Where(point => point.First >= 0);
                yield return (image, [.. points.Select(point => new Vector2D(point.Column + 0.5, point.Row + 0.5))]);
            }
        }
    }

    private static IEnumerable<(string Image, Vector2D[] Points)> CuLane(string folder)
    {
        foreach (string file in Directory.EnumerateFiles(folder, "*.lines.txt", SearchOption.AllDirectories))
        {
            string image = file.Replace(".lines.txt", ".png", StringComparison.Ordinal);
            foreach (string line in File.ReadLines(file))
            {
                string[] numbers = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
                double[] values = [.. numbers.Select(text => double.Parse(text, CultureInfo.InvariantCulture) + 0.5)];
                yield return (image, Pairs(values));
            }
        }
    }

    private static IEnumerable<(string Image, Vector2D[] Points)> OpenLane(string folder)
    {
        foreach (string file in Directory.EnumerateFiles(folder, "*.json", SearchOption.AllDirectories).Where(IsFrame))
        {
            using JsonDocument frame = JsonDocument.Parse(File.ReadAllText(file));
            string image = Path.Combine(folder, "images", frame.RootElement.GetProperty("file_path").GetString()!);
            foreach (JsonElement line in frame.RootElement.GetProperty("lane_lines").EnumerateArray())
            {
                double[][] uv = [.. line.GetProperty("uv").EnumerateArray().Select(Numbers)];
                yield return (image, [.. uv[0].Zip(uv[1], (u, v) => new Vector2D(u, v))]);
            }
        }

        static bool IsFrame(string file) => file.Contains("lane3d", StringComparison.Ordinal);
    }

    private static IEnumerable<(string Image, Vector2D[] Points)> Bdd100K(string folder)
    {
        string file = Path.Combine(folder, "labels", "lane", "polygons", "lane_train.json");
        using JsonDocument frames = JsonDocument.Parse(File.ReadAllText(file));
        foreach (JsonElement frame in frames.RootElement.EnumerateArray())
        {
            string image = Path.Combine(folder, "images", "100k", "train", frame.GetProperty("name").GetString()!);
            foreach (JsonElement label in frame.GetProperty("labels").EnumerateArray())
            {
                IEnumerable<double[]> vertices = label.GetProperty("poly2d")[0].GetProperty("vertices").EnumerateArray().Select(Numbers);
                yield return (image, [.. vertices.Select(vertex => new Vector2D(vertex[0], vertex[1]))]);
            }
        }
    }

    private static IEnumerable<(string Image, Vector2D[] Points)> OpenLabel(string folder)
    {
        foreach (string file in Directory.EnumerateFiles(Path.Combine(folder, "labels"), "*.json", SearchOption.AllDirectories))
        {
            using JsonDocument sequence = JsonDocument.Parse(File.ReadAllText(file));
            foreach (JsonProperty frame in sequence.RootElement.GetProperty("openlabel").GetProperty("frames").EnumerateObject())
            {
                JsonElement stream = frame.Value.GetProperty("frame_properties").GetProperty("streams").GetProperty("camera");
                string image = Path.Combine(folder, stream.GetProperty("uri").GetString()!);
                IEnumerable<JsonElement> lines = frame
                    .Value.GetProperty("objects")
                    .EnumerateObject()
                    .SelectMany(item => item.Value.GetProperty("object_data").EnumerateObject())
                    .Where(data => data.Name == "poly2d")
                    .SelectMany(data => data.Value.EnumerateArray());
                foreach (JsonElement line in lines)
                {
                    yield return (image, Pairs(Numbers(line.GetProperty("val"))));
                }
            }
        }
    }

    private static Vector2D[] Pairs(double[] values) => [.. values.Chunk(2).Select(pair => new Vector2D(pair[0], pair[1]))];

    private static double[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];
}
