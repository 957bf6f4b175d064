using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Lanes;

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
                    // The point in the middle of the row is within the pixel that starts at the column: half a pixel from its middle at
                    // most.
                    const double halfPixel = 0.5001;
                    Assert.True(
                        columns[i] == -2 || label.Lanes!.Markings!.Any(view => Crosses(view, columns[i] + 0.5, rows[i] + 0.5, halfPixel))
                    );
                }
            }
        }
    }

    [Fact]
    public void TuSimple_has_the_five_nearest_lanes_or_all()
    {
        Folder.Export("tusimple", simulated.Open());
        Folder.Export("tusimple", simulated.Open(), new ExportOptions { Lanes = LaneSelection.All }, "all");

        int[][][] nearest = [.. Folder.Lines("out/label_data_train.json").Select(LanesOf)];
        int[][][] all = [.. Folder.Lines("all/label_data_train.json").Select(LanesOf)];
        Assert.Equal(all.Select(lanes => Math.Min(lanes.Length, 5)), nearest.Select(lanes => lanes.Length));
        Assert.All(
            nearest.Zip(all),
            frame =>
                Assert.Subset(
                    frame.Second.Select(lane => string.Join(' ', lane)).ToHashSet(),
                    frame.First.Select(lane => string.Join(' ', lane)).ToHashSet()
                )
        );
        Assert.Equal(all.Length, all.Count(lanes => lanes.Length > 0));
    }

    private static int[][] LanesOf(string line)
    {
        using JsonDocument json = JsonDocument.Parse(line);
        return [.. json.RootElement.GetProperty("lanes").EnumerateArray().Select(Ints)];
    }

    [Fact]
    public void OpenLane_points_project_onto_their_pixels()
    {
        Folder.Export("openlane", simulated.Open());
        string[] list = Folder.Lines("out/train.txt");
        Assert.Equal(Known().Length, list.Length);
        int points = 0;
        foreach (string image in list)
        {
            using JsonDocument json = JsonDocument.Parse(
                File.ReadAllText(Folder.PathOf("out/lane3d/" + Path.ChangeExtension(image, ".json")))
            );
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
        using JsonDocument json = JsonDocument.Parse(
            File.ReadAllText(Folder.PathOf("out/lane3d/" + Path.ChangeExtension(Folder.Lines("out/train.txt")[0], ".json")))
        );
        double[][] extrinsic = Matrix(json.RootElement.GetProperty("extrinsic"));
        JsonElement line = json.RootElement.GetProperty("lane_lines")[0];
        double[][] xyz = Matrix(line.GetProperty("xyz"));
        double[] inVehicle =
        [
            .. extrinsic.Take(3).Select(row => (row[0] * xyz[0][0]) + (row[1] * xyz[1][0]) + (row[2] * xyz[2][0]) + row[3]),
        ];

        // The origin is the foot of the model's origin on the road, and the axes are the body's: forward, left, up.
        EgoLabel ego = label.Ego;
        Vector3D right = ego.Axes!.Value.Right,
            forward = ego.Axes.Value.Forward,
            up = ego.Axes.Value.Up;
        Vector3D offset = label.Lanes!.Lines[0].Points[0].World - (ego.Position - (up * (ego.HeightAboveGroundMetres!.Value * up.Z)));
        const double roundingMetres = 0.001;
        Assert.Equal(forward.Dot(offset), inVehicle[0], roundingMetres);
        Assert.Equal(-right.Dot(offset), inVehicle[1], roundingMetres);
        Assert.Equal(up.Dot(offset), inVehicle[2], roundingMetres);
    }

    [Fact]
    public void OpenLane_lines_near_the_car_lie_at_the_height_of_the_road()
    {
        Folder.Export("openlane", simulated.Open());
        int points = 0;
        foreach (string image in Folder.Lines("out/train.txt"))
        {
            using JsonDocument json = JsonDocument.Parse(
                File.ReadAllText(Folder.PathOf("out/lane3d/" + Path.ChangeExtension(image, ".json")))
            );
            double[][] extrinsic = Matrix(json.RootElement.GetProperty("extrinsic"));
            foreach (JsonElement line in json.RootElement.GetProperty("lane_lines").EnumerateArray())
            {
                double[][] xyz = Matrix(line.GetProperty("xyz"));
                for (int i = 0; i < xyz[0].Length && xyz[0][i] < 10; i++, points++)
                {
                    // On a road that bends in height by a radius of 500 m, 10 m ahead is 10² / 1000 = 0.1 m off the tangent; the crown and
                    // the paint are as much.
                    const double roadMetres = 0.2;
                    double height =
                        (extrinsic[2][0] * xyz[0][i]) + (extrinsic[2][1] * xyz[1][i]) + (extrinsic[2][2] * xyz[2][i]) + extrinsic[2][3];
                    Assert.InRange(height, -roadMetres, roadMetres);
                }
            }
        }

        Assert.True(points > 20);
    }

    [Fact]
    public void OpenLane_visibility_is_not_occlusion()
    {
        SetMarkings(new LaneLineView(1, true, [PointAt(20, 50, 5, true), PointAt(30, 40, 10, false), PointAt(35, 35, 20, true)]));
        Folder.Export("openlane", Session.Open());

        Assert.Equal("[1,1,1]", Assert.Single(LinesOf()).GetProperty("visibility").GetRawText());
    }

    [Fact]
    public void OpenLane_line_that_leaves_and_reenters_the_image_is_one()
    {
        SetMarkings(
            new LaneLineView(1, true, [PointAt(20, 50, 5), PointAt(0, 45, 8)]),
            new LaneLineView(1, true, [PointAt(0, 40, 14), PointAt(20, 35, 30)])
        );
        Folder.Export("openlane", Session.Open());

        Assert.Equal("[[20,0,0,20],[50,45,40,35]]", Assert.Single(LinesOf()).GetProperty("uv").GetRawText());
    }

    [Fact]
    public void OpenLane_line_interrupted_within_the_image_becomes_two()
    {
        SetMarkings(
            new LaneLineView(1, true, [PointAt(20, 50, 5), PointAt(24, 45, 8)]),
            new LaneLineView(1, true, [PointAt(28, 40, 14), PointAt(32, 35, 30)])
        );
        Folder.Export("openlane", Session.Open());

        Assert.Equal(2, LinesOf().Length);
    }

    [Theory]
    [InlineData(MarkingColour.White, MarkingStyle.Dashed, 1)]
    [InlineData(MarkingColour.White, MarkingStyle.Solid, 2)]
    [InlineData(MarkingColour.White, MarkingStyle.DoubleSolid, 4)]
    [InlineData(MarkingColour.Yellow, MarkingStyle.Dashed, 7)]
    [InlineData(MarkingColour.Yellow, MarkingStyle.Solid, 8)]
    [InlineData(MarkingColour.Yellow, MarkingStyle.DoubleSolid, 10)]
    public void OpenLane_category_is_that_of_the_paint(MarkingColour colour, MarkingStyle style, int expected)
    {
        SetMarkings(new LaneLineView(1, true, [PointAt(20, 50, 5), PointAt(30, 40, 10)]) { Paint = new MarkingPaint(style, colour, 0.15) });
        Folder.Export("openlane", Session.Open());

        Assert.Equal(expected, Assert.Single(LinesOf()).GetProperty("category").GetInt32());
    }

    [Fact]
    public void OpenLane_category_of_a_boundary_is_unknown()
    {
        string lanes = JsonLabelWriter.Lanes(
            new LanesLabel
            {
                Status = LaneStatus.Known,
                Source = "simulation",
                Boundaries = [new LaneLineView(1, true, [PointAt(20, 50, 5), PointAt(30, 40, 10)])],
            }
        );
        Session.Lines.ForEach(line => line["lanes"] = JsonNode.Parse(lanes));
        Folder.Export("openlane", Session.Open());

        Assert.Equal(0, Assert.Single(LinesOf()).GetProperty("category").GetInt32());
    }

    /// <summary>Gives all frames of the hand-written session these markings.</summary>
    private void SetMarkings(params LaneLineView[] views)
    {
        LaneLineView[] painted =
        [
            .. views.Select(view => view with { Paint = view.Paint ?? new MarkingPaint(MarkingStyle.Solid, MarkingColour.White, 0.15) }),
        ];
        string lanes = JsonLabelWriter.Lanes(
            new LanesLabel
            {
                Status = LaneStatus.Known,
                Source = "simulation",
                Markings = painted,
            }
        );
        Session.Lines.ForEach(line => line["lanes"] = JsonNode.Parse(lanes));
    }

    /// <summary>
    /// A point that the hand-written session's camera, with a focal length of 30 pixels and its centre at (40, 30), sees at a pixel.
    /// </summary>
    private static LaneLinePoint PointAt(double u, double v, double forward, bool? isHidden = null)
    {
        var inCamera = new Vector3D((u - 40) * forward / 30, forward, (30 - v) * forward / 30);
        return new LaneLinePoint(inCamera, inCamera, new Vector2D(u, v), isHidden);
    }

    private JsonElement[] LinesOf() =>
        [
            .. JsonDocument
                .Parse(File.ReadAllText(Folder.PathOf("out/lane3d/train/segment-0000/00000000.json")))
                .RootElement.GetProperty("lane_lines")
                .EnumerateArray(),
        ];

    private static bool Crosses(LaneLineView view, double x, double y, double within) =>
        view
            .Points.Zip(view.Points.Skip(1))
            .Any(piece =>
            {
                (Vector2D a, Vector2D b) = (piece.First.Pixel, piece.Second.Pixel);
                return a.Y != b.Y && (a.Y - y) * (b.Y - y) <= 0 && Math.Abs(a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y)) - x) <= within;
            });

    private static int[] Ints(JsonElement list) => [.. list.EnumerateArray().Select(item => item.GetInt32())];

    private static double[][] Matrix(JsonElement rows) =>
        [.. rows.EnumerateArray().Select(row => row.EnumerateArray().Select(item => item.GetDouble()).ToArray())];

    private FrameLabel[] Known()
    {
        FrameLabel[] known = [.. simulated.Open().ReadLabels().Where(label => label.Lanes is { Status: LaneStatus.Known })];
        Assert.NotEmpty(known);
        return known;
    }
}
