using System.Text.Json;
using Harvester.Capture.Labels;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Datasets.Tests.Exports.Lanes;

/// <summary>The two formats of lane lines, read as their descriptions have it, against the labels and against each other.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class LaneFormatTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void TuSimple_columns_lie_on_the_markings()
    {
        Folder.Export("tusimple", simulated.Open());
        FrameLabel[] known = Known();
        string[] lines = Folder.Lines("out/label_data_train.json");
        Assert.Equal(known.Length, lines.Length);
        foreach ((string line, FrameLabel label) in lines.Zip(known))
        {
            using JsonDocument json = JsonDocument.Parse(line);
            int[] rows = Ints(json.RootElement.GetProperty("h_samples"));
            // 150 rows: from the first multiple of ten in the lower two thirds.
            Assert.Equal([50, 60, 70, 80, 90, 100, 110, 120, 130, 140], rows);
            Assert.True(File.Exists(Folder.PathOf("out/" + json.RootElement.GetProperty("raw_file").GetString())));
            foreach (JsonElement lane in json.RootElement.GetProperty("lanes").EnumerateArray())
            {
                int[] columns = Ints(lane);
                Assert.Equal(rows.Length, columns.Length);
                Assert.Contains(columns, column => column != -2);
                for (int i = 0; i < rows.Length; i++)
                {
                    // The point in the middle of the row is within the pixel that starts at the column: half a pixel from its middle at most.
                    const double halfPixel = 0.5001;
                    Assert.True(columns[i] == -2 || label.Lanes!.Markings.Any(view => Crosses(view, columns[i] + 0.5, rows[i] + 0.5, halfPixel)));
                }
            }
        }
    }

    [Fact]
    public void OpenLane_points_projected_with_the_intrinsics_fall_onto_their_pixels()
    {
        Folder.Export("openlane", simulated.Open());
        string[] list = Folder.Lines("out/train.txt");
        Assert.Equal(Known().Length, list.Length);
        int points = 0;
        foreach (string image in list)
        {
            using JsonDocument json = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/lane3d/" + Path.ChangeExtension(image, ".json"))));
            Assert.Equal(image, json.RootElement.GetProperty("file_path").GetString());
            Assert.True(File.Exists(Folder.PathOf("out/images/" + image)));
            double[][] k = Matrix(json.RootElement.GetProperty("intrinsic"));
            foreach (JsonElement line in json.RootElement.GetProperty("lane_lines").EnumerateArray())
            {
                double[][] uv = Matrix(line.GetProperty("uv"));
                double[][] xyz = Matrix(line.GetProperty("xyz"));
                Assert.Equal(uv[0].Length, line.GetProperty("visibility").GetArrayLength());
                for (int i = 0; i < uv[0].Length; i++, points++)
                {
                    // x forward, y left, z up. Metres are rounded to 0.1 mm: at 1 m and f = 161 pixels that is 0.008 pixels.
                    double rounding = 0.001 + (0.0002 * k[0][0] * (1 + Math.Abs(xyz[1][i] / xyz[0][i])) / xyz[0][i]);
                    Assert.Equal((k[0][0] * -xyz[1][i] / xyz[0][i]) + k[0][2], uv[0][i], rounding);
                    Assert.Equal((k[1][1] * -xyz[2][i] / xyz[0][i]) + k[1][2], uv[1][i], rounding);
                }
            }
        }

        Assert.True(points > 20);
    }

    [Fact]
    public void OpenLane_extrinsic_puts_the_camera_on_the_vehicle()
    {
        Folder.Export("openlane", simulated.Open());
        FrameLabel label = Known()[0];
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/lane3d/" + Path.ChangeExtension(Folder.Lines("out/train.txt")[0], ".json"))));
        double[][] extrinsic = Matrix(json.RootElement.GetProperty("extrinsic"));
        JsonElement line = json.RootElement.GetProperty("lane_lines")[0];
        double[][] xyz = Matrix(line.GetProperty("xyz"));
        double[] inVehicle = [.. extrinsic.Take(3).Select(row => (row[0] * xyz[0][0]) + (row[1] * xyz[1][0]) + (row[2] * xyz[2][0]) + row[3])];

        // Heading h is counter-clockwise from north: forward (-sin h, cos h), left (-cos h, -sin h).
        Vector3D offset = label.Lanes!.Markings[0].Points[0].World - label.Ego.Position;
        double h = label.Ego.HeadingDegrees * Math.PI / 180;
        const double roundingMetres = 0.001;
        Assert.Equal((-Math.Sin(h) * offset.X) + (Math.Cos(h) * offset.Y), inVehicle[0], roundingMetres);
        Assert.Equal((-Math.Cos(h) * offset.X) - (Math.Sin(h) * offset.Y), inVehicle[1], roundingMetres);
        Assert.Equal(offset.Z, inVehicle[2], roundingMetres);
    }

    private static bool Crosses(LaneLineView view, double x, double y, double within) => view.Points.Zip(view.Points.Skip(1)).Any(piece =>
    {
        (Vector2D a, Vector2D b) = (piece.First.Pixel, piece.Second.Pixel);
        return a.Y != b.Y && (a.Y - y) * (b.Y - y) <= 0 && Math.Abs(a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y)) - x) <= within;
    });

    private static int[] Ints(JsonElement list) => [.. list.EnumerateArray().Select(item => item.GetInt32())];

    private static double[][] Matrix(JsonElement rows) => [.. rows.EnumerateArray().Select(row => row.EnumerateArray().Select(item => item.GetDouble()).ToArray())];

    private FrameLabel[] Known()
    {
        FrameLabel[] known = [.. simulated.Open().ReadLabels().Where(label => label.Lanes is { Status: LaneStatus.Known })];
        Assert.NotEmpty(known);
        return known;
    }
}
