using System.Globalization;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class CalibrateCommandTests
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Calibrate_finds_the_lens_of_the_simulated_game()
    {
        // In 400 x 300 pixels a marker is located to some 0.1 px of 240 px to the upper edge.
        const double tolerance = 0.002;

        CliRun run = CliRun.Of(
            "calibrate",
            "--focal-scale",
            "1.02",
            "--centre-offset",
            "0.01,-0.005",
            "--size",
            "400x300",
            "--fov",
            "60",
            "--seed",
            "5"
        );

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(1.02, Value(run, "FocalScale"), tolerance);
        Assert.Equal(0.01, Value(run, "CentreOffsetX"), tolerance);
        Assert.Equal(-0.005, Value(run, "CentreOffsetY"), tolerance);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Calibrate_finds_a_lens_shifted_by_a_tenth_of_the_width()
    {
        CliRun run = CliRun.Of("calibrate", "--seed", "5", "--size", "400x300", "--centre-offset", "0.1,0");

        Assert.Equal((0, ""), (run.ExitCode, run.Error));

        // A tenth of 400 pixels; 0.0005 of them are 0.2 px.
        Assert.Equal(0.1, Value(run, "CentreOffsetX"), 0.0005);
        Assert.Equal(0, Value(run, "CentreOffsetY"), 0.0005);
        Assert.Contains("markers not used for the fit", run.Out, StringComparison.Ordinal);
        Assert.Contains("; uncertainty at the corners: 0.", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Calibrate_finds_a_shifted_lens_at_800_x_600()
    {
        CliRun run = CliRun.Of("calibrate", "--seed", "5", "--centre-offset", "0.1,0");

        Assert.Equal((0, ""), (run.ExitCode, run.Error));
        Assert.Equal(0.1, Value(run, "CentreOffsetX"), 0.0005);
    }

    [Fact]
    public void Calibrate_that_misses_the_threshold_fails_with_a_message()
    {
        CliRun run = CliRun.Of("calibrate", "--size", "288x216", "--seed", "5", "--threshold", "0.001");

        run.AssertFailed(4, "more than the 0.001 px allowed");
    }

    [Fact]
    public void Calibrate_with_a_focal_scale_of_nothing_is_refused() =>
        CliRun.Of("calibrate", "--focal-scale", "0").AssertFailed(2, "--focal-scale takes a number greater than 0");

    [Theory]
    [InlineData("--size", "64x48")]
    [InlineData("--size", "287x216")]
    [InlineData("--size", "288x215")]
    [InlineData("--k1", "-5")]
    [InlineData("--k2", "1.5")]
    public void Calibrate_with_an_impossible_value_is_a_usage_error(string option, string value) =>
        CliRun.Of("calibrate", option, value).AssertFailed(ExitCode.Usage, option);

    private static double Value(CliRun run, string key) =>
        double.Parse(
            run.Out.Split('\n').Single(line => line.StartsWith(key + " = ", StringComparison.Ordinal))[(key.Length + 3)..],
            CultureInfo.InvariantCulture
        );
}
