using System.Text.Json;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class BoxesCommandTests
{
    private const string Camera =
        """{ "position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 90, "width": 800, "height": 600 }""";

    /// <summary>256 rays, spread evenly: an error of a few rays on a half plane.</summary>
    private const double SamplingTolerance = 4.0 / 256;

    [Fact]
    public void Boxes_of_a_cuboid_ahead_gives_its_box_worked_out_by_hand()
    {
        // f = 300. The near face of a 2 m cube centred 11 m ahead lies at 10 m: 400 ± 300 * 1/10, 300 ± 300 * 1/10.
        JsonElement cuboid = Boxes(Camera, """{ "name": "cube", "centre": [0, 11, 0], "halfExtents": [1, 1, 1], "rotation": [0, 0, 0] }""")[
            0
        ];

        Assert.Equal("cube", cuboid.GetProperty("name").GetString());
        Assert.Equal("inImage", cuboid.GetProperty("outcome").GetString());
        AssertBox([370, 270, 430, 330], cuboid.GetProperty("box2d"));
        AssertBox([370, 270, 430, 330], cuboid.GetProperty("box2dAmodal"));
        Assert.Equal(0, cuboid.GetProperty("truncatedFraction").GetDouble());
        Assert.Equal(0, cuboid.GetProperty("occludedFraction").GetDouble());
        Assert.Equal(11, cuboid.GetProperty("distanceMetres").GetDouble());
        Assert.Equal(4, cuboid.GetProperty("silhouette").GetArrayLength());
    }

    [Fact]
    public void Boxes_of_a_model_takes_the_middle_of_its_corners()
    {
        JsonElement cuboid = Boxes(
            Camera,
            """{ "position": [0, 10, 0], "modelMin": [-1, 0, -1], "modelMax": [1, 2, 1], "rotation": [0, 0, 0] }"""
        )[0];

        AssertBox([370, 270, 430, 330], cuboid.GetProperty("box2d"));
    }

    [Fact]
    public void Boxes_of_a_plate_at_the_edge_is_half_truncated()
    {
        // A plate 10 m ahead, 40/3 m to the right: its middle is on the right edge, 300 * (40/3)/10 = 400.
        JsonElement cuboid = Boxes(
            Camera,
            """{ "centre": [13.333333333333334, 10, 0], "halfExtents": [1, 0, 1], "rotation": [0, 0, 0] }"""
        )[0];

        AssertBox([770, 270, 800, 330], cuboid.GetProperty("box2d"));
        AssertBox([770, 270, 830, 330], cuboid.GetProperty("box2dAmodal"));
        Assert.Equal(0.5, cuboid.GetProperty("truncatedFraction").GetDouble(), 9);
    }

    [Fact]
    public void Boxes_of_a_cuboid_behind_another_counts_what_hides_it()
    {
        // The screen in front covers the right half of the view, and so half of the cube behind it.
        JsonElement cuboid = Boxes(
            Camera,
            """{ "centre": [0, 20, 0], "halfExtents": [1, 1, 1], "rotation": [0, 0, 0] }""",
            """{ "centre": [5, 5, 0], "halfExtents": [5, 0, 5], "rotation": [0, 0, 0] }"""
        )[0];

        Assert.Equal(0.5, cuboid.GetProperty("occludedFraction").GetDouble(), SamplingTolerance);
    }

    [Theory]
    [InlineData("""{ "centre": [0, 20, 0], "halfExtents": [1, 2, 1], "rotation": [0, 0, 30] }""")]
    [InlineData("""{ "centre": [0, 20, 0], "halfExtents": [2, 1, 1], "rotation": [0, 0, 120] }""")]
    public void Boxes_of_coinciding_cuboids_hide_none_of_each_other(string second)
    {
        JsonElement cuboids = Boxes(Camera, """{ "centre": [0, 20, 0], "halfExtents": [1, 2, 1], "rotation": [0, 0, 30] }""", second);

        foreach (JsonElement cuboid in cuboids.EnumerateArray())
        {
            Assert.Equal(0, cuboid.GetProperty("occludedFraction").GetDouble());
            Assert.Equal("rays", cuboid.GetProperty("occlusionMethod").GetString());
        }
    }

    [Fact]
    public void Boxes_of_a_cuboid_partly_inside_another_counts_that_part()
    {
        // A plate 10 m ahead from x = -1 to 1; the second cuboid holds its right half.
        JsonElement cuboids = Boxes(
            Camera,
            """{ "centre": [0, 10, 0], "halfExtents": [1, 0, 1], "rotation": [0, 0, 0] }""",
            """{ "centre": [5, 10, 0], "halfExtents": [5, 2, 5], "rotation": [0, 0, 0] }"""
        );

        Assert.Equal(0.5, cuboids[0].GetProperty("occludedFraction").GetDouble(), SamplingTolerance);
        Assert.Equal(0, cuboids[1].GetProperty("occludedFraction").GetDouble());
    }

    [Theory]
    [InlineData(0.1)]
    [InlineData(0.0001)]
    public void Boxes_of_a_cuboid_smaller_than_a_pixel_has_an_occlusion(double half)
    {
        // 300 px · 0.1 m / 900 m = 0.03 px, between the centres of pixels; two screens at 9 m cover x from -9.9 to 10.1.
        string small = FormattableString.Invariant(
            $$"""{ "centre": [10, 900, 10], "halfExtents": [{{half}}, {{half}}, {{half}}], "rotation": [0, 0, 0] }"""
        );

        JsonElement free = Boxes(Camera, small)[0];
        JsonElement hidden = Boxes(
            Camera,
            small,
            """{ "centre": [5.1, 9, 0], "halfExtents": [5, 0, 5], "rotation": [0, 0, 0] }""",
            """{ "centre": [-4.9, 9, 0], "halfExtents": [5, 0, 5], "rotation": [0, 0, 0] }"""
        )[0];

        Assert.Equal("inImage", free.GetProperty("outcome").GetString());
        Assert.Equal(0, free.GetProperty("occludedFraction").GetDouble());
        Assert.Equal(1, hidden.GetProperty("occludedFraction").GetDouble());
    }

    [Fact]
    public void Boxes_of_a_cuboid_behind_the_camera_has_no_box()
    {
        JsonElement cuboid = Boxes(Camera, """{ "centre": [0, -20, 0], "halfExtents": [1, 1, 1], "rotation": [0, 0, 0] }""")[0];

        Assert.Equal("behindNearPlane", cuboid.GetProperty("outcome").GetString());
        Assert.Equal(JsonValueKind.Null, cuboid.GetProperty("box2d").ValueKind);
        Assert.Equal(JsonValueKind.Null, cuboid.GetProperty("occludedFraction").ValueKind);
        Assert.Equal("none", cuboid.GetProperty("occlusionMethod").GetString());
        Assert.Equal(1, cuboid.GetProperty("truncatedFraction").GetDouble());
    }

    [Fact]
    public void Boxes_of_a_cuboid_beside_the_image_has_no_box()
    {
        JsonElement cuboid = Boxes(Camera, """{ "centre": [50, 10, 0], "halfExtents": [1, 1, 1], "rotation": [0, 0, 0] }""")[0];

        Assert.Equal("outsideImage", cuboid.GetProperty("outcome").GetString());
        Assert.Equal(JsonValueKind.Null, cuboid.GetProperty("occludedFraction").ValueKind);
        Assert.Equal(1, cuboid.GetProperty("truncatedFraction").GetDouble());
    }

    [Theory]
    [InlineData("""{ "camera": 1, "cuboids": [] }""", "camera must be an object, not 1")]
    [InlineData("""{ "cuboids": [] }""", "camera is missing")]
    [InlineData("""{ "camera": {}, "cuboids": [], "cubes": [] }""", "cubes is an unknown field")]
    [InlineData(
        """{ "camera": { "position": [0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 50, "width": 8, "height": 6 }, "cuboids": [] }""",
        "camera.position must be a list of 3 numbers"
    )]
    [InlineData(
        """{ "camera": { "position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 200"""
            + """, "width": 8, "height": 6 }, "cuboids": [] }""",
        "camera: verticalFovDegrees"
    )]
    [InlineData(
        """{ "camera": { "position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 50"""
            + """, "width": 8.5, "height": 6 }, "cuboids": [] }""",
        "camera.width must be a whole number"
    )]
    [InlineData(
        """{ "camera": { "position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 90"""
            + """, "width": 8, "height": 6, "fy": 4 }, "cuboids": [] }""",
        "camera.fy is 4"
    )]
    [InlineData("{ camera", "invalid JSON at line 1, byte 3")]
    [InlineData("[]", "must be an object")]
    public void Boxes_of_a_malformed_scene_names_file_and_field(string scene, string message)
    {
        using var folder = new TemporaryFolder();
        string path = folder.File("scene.json", scene);

        CliRun run = CliRun.Of("boxes", path);

        run.AssertFailed(ExitCode.BadData, message);
        Assert.Contains("scene.json", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Boxes_of_a_missing_file_is_an_input_error() =>
        CliRun.Of("boxes", "no-such-scene.json").AssertFailed(ExitCode.InputOutput, "no-such-scene.json");

    private static JsonElement Boxes(string camera, params string[] cuboids)
    {
        using var folder = new TemporaryFolder();
        string scene = folder.File("scene.json", $$"""{ "camera": {{camera}}, "cuboids": [{{string.Join(", ", cuboids)}}] }""");

        CliRun run = CliRun.Of("boxes", scene);

        Assert.Equal("", run.Error);
        Assert.Equal(0, run.ExitCode);
        return JsonDocument.Parse(run.Out).RootElement.GetProperty("cuboids");
    }

    private static void AssertBox(double[] expected, JsonElement box)
    {
        const int roundingDigits = 9;
        double[] sides = [.. box.EnumerateArray().Select(side => side.GetDouble())];
        Assert.Equal(expected.Length, sides.Length);
        for (int i = 0; i < sides.Length; i++)
        {
            Assert.Equal(expected[i], sides[i], roundingDigits);
        }
    }
}
