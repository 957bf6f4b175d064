using System.Globalization;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class ProjectCommandTests
{
    private static readonly string[] Camera = ["project", "--position", "0,0,0", "--rotation", "0,0,0", "--fov", "90", "--size", "800x600"];

    [Fact]
    public void Project_of_points_ahead_gives_pixels_worked_out_by_hand()
    {
        // fov 90: fy = 600 / (2 tan 45) = 300, and fx = 800 / (2 tan 45 * 4/3) = 300.
        // (1, 10, 2): u = 400 + 300 * 1/10 = 430, v = 300 - 300 * 2/10 = 240, depth 10.
        CliRun run = CliRun.WithInput("0,10,0\n1,10,2\n", Camera);

        Assert.Equal(0, run.ExitCode);
        string[] rows = run.Out.Split('\n');
        Assert.Equal("u,v,depth,outcome", rows[0]);
        AssertRow(rows[1], 400, 300, 10, "inImage");
        AssertRow(rows[2], 430, 240, 10, "inImage");
    }

    [Fact]
    public void Project_through_a_lens_gives_pixels_worked_out_by_hand()
    {
        // (5, 10, 0): x = 0.5, q = 0.25, 1 + 0.2 q = 1.05; u = 400 + 0.1 * 800 + 2 * 300 * 0.5 * 1.05 = 795, v = 300 - 0.05 * 600 = 270.
        CliRun run = CliRun.WithInput("5,10,0\n", [.. Camera, "--focal-scale", "2", "--centre-offset", "0.1,-0.05", "--k1", "0.2"]);

        AssertRow(run.Out.Split('\n')[1], 795, 270, 10, "inImage");
    }

    [Fact]
    public void Project_takes_a_calibrated_lens_or_numbers_but_not_both()
    {
        using var folder = new TemporaryFolder();
        string file = folder.File("lens.ini", "FocalScale = 2\nCentreOffsetX = 0.1\nCentreOffsetY = -0.05\nK1 = 0.2\nK2 = 0\n");

        AssertRow(CliRun.WithInput("5,10,0\n", [.. Camera, "--calibration", file]).Out.Split('\n')[1], 795, 270, 10, "inImage");
        CliRun.Of([.. Camera, "--calibration", file, "--k1", "0.2"]).AssertFailed(ExitCode.Usage, "--calibration and --k1");
    }

    [Fact]
    public void Project_of_points_out_of_view_leaves_the_pixel_empty()
    {
        CliRun run = CliRun.WithInput("0,-3,0\n0,0.1,0\n100,10,0\n", Camera);

        string[] rows = run.Out.Split('\n');
        Assert.Equal(",,-3,behindNearPlane", rows[1]);
        Assert.Equal(",,0.1,behindNearPlane", rows[2]);
        AssertRow(rows[3], 3400, 300, 10, "outsideImage");
    }

    [Fact]
    public void Project_with_an_aspect_uses_that_of_the_window()
    {
        // The window is twice as wide as high: fx = 800 / (2 tan 45 * 2) = 200, so u = 400 + 200 * 1/10.
        CliRun run = CliRun.WithInput("1,10,0\n", [.. Camera, "--aspect", "2"]);

        AssertRow(run.Out.Split('\n')[1], 420, 300, 10, "inImage");
    }

    [Fact]
    public void Project_accepts_a_negative_position_and_rotation()
    {
        // A yaw of 90 degrees looks west (-x): the point 10 m west of the camera is in the middle.
        CliRun run = CliRun.WithInput(
            "-15,-6,-7\n",
            "project",
            "--position",
            "-5,-6,-7",
            "--rotation",
            "-0,0,90",
            "--fov",
            "50",
            "--size",
            "100x100"
        );

        AssertRow(run.Out.Split('\n')[1], 50, 50, 10, "inImage");
    }

    [Fact]
    public void Project_with_near_moves_the_near_plane()
    {
        CliRun run = CliRun.WithInput("0,10,0\n", [.. Camera, "--near", "11"]);

        Assert.Equal(",,10,behindNearPlane", run.Out.Split('\n')[1]);
    }

    [Fact]
    public void Project_of_a_file_skips_blank_lines_and_comments()
    {
        using var folder = new TemporaryFolder();
        string points = folder.File("points.csv", "# x,y,z\n\n0,10,0\n");

        CliRun run = CliRun.Of([.. Camera, "--points", points]);

        Assert.Equal(["u,v,depth,outcome", "400,300,10,inImage", ""], run.Out.Split('\n'));
    }

    [Theory]
    [InlineData("1,2")]
    [InlineData("1,2,3,4")]
    [InlineData("1,2,x")]
    [InlineData("1,2,NaN")]
    public void Project_of_a_malformed_point_names_its_line(string line) =>
        CliRun.WithInput($"0,10,0\n{line}\n", Camera).AssertFailed(ExitCode.BadData, "standard input, line 2");

    [Fact]
    public void Project_of_a_missing_file_is_an_input_error() =>
        CliRun.Of([.. Camera, "--points", "no-such-file.csv"]).AssertFailed(ExitCode.InputOutput, "no-such-file.csv");

    [Theory]
    [InlineData("--size", "0x600")]
    [InlineData("--size", "800")]
    [InlineData("--size", "70000x600")]
    [InlineData("--fov", "0")]
    [InlineData("--fov", "180")]
    [InlineData("--fov", "wide")]
    [InlineData("--near", "0")]
    [InlineData("--aspect", "-1")]
    [InlineData("--position", "1,2")]
    [InlineData("--rotation", "1,2,Infinity")]
    public void Project_with_an_impossible_value_is_a_usage_error(string option, string value)
    {
        List<string> arguments = [.. Camera];
        int at = arguments.IndexOf(option);
        if (at >= 0)
        {
            arguments.RemoveRange(at, 2);
        }

        CliRun.Of([.. arguments, option, value]).AssertFailed(ExitCode.Usage, option);
    }

    [Fact]
    public void Project_without_position_is_a_usage_error() =>
        CliRun.Of("project", "--rotation", "0,0,0", "--fov", "50", "--size", "8x6").AssertFailed(ExitCode.Usage, "--position");

    private static void AssertRow(string row, double u, double v, double depth, string outcome)
    {
        // The sine and cosine of a right angle are off by 1e-16, some hundred pixels multiply that.
        const int roundingDigits = 9;
        string[] cells = row.Split(',');
        Assert.Equal(u, double.Parse(cells[0], CultureInfo.InvariantCulture), roundingDigits);
        Assert.Equal(v, double.Parse(cells[1], CultureInfo.InvariantCulture), roundingDigits);
        Assert.Equal(depth, double.Parse(cells[2], CultureInfo.InvariantCulture), roundingDigits);
        Assert.Equal(outcome, cells[3]);
    }
}
