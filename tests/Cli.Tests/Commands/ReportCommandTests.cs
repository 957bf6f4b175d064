using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class ReportCommandTests
{
    private const string Header =
        """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }""";

    [Fact]
    public void Report_goes_into_the_session_unless_a_file_is_named()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);
        string page = Path.Combine(folder.Path, "report.html");
        string named = Path.Combine(folder.Path, "named.html");

        CliRun run = CliRun.Of("report", folder.Path);
        CliRun runNamed = CliRun.Of("report", folder.Path, "--out", named);

        Assert.Equal($"{page}: 0 frames shown\n", run.Out);
        Assert.Equal($"{named}: 0 frames shown\n", runNamed.Out);
        Assert.Equal(File.ReadAllText(page), File.ReadAllText(named));
    }

    [Fact]
    public void Report_to_a_missing_folder_is_an_output_error()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);

        CliRun
            .Of("report", folder.Path, "--out", Path.Combine(folder.Path, "none", "page.html"))
            .AssertFailed(ExitCode.InputOutput, "none");
    }

    [Fact]
    public void Report_of_a_malformed_session_names_file_and_field()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", """{ "formatVersion": 1, "game": "simulation" }""");

        CliRun.Of("report", folder.Path).AssertFailed(ExitCode.BadData, "session.json: image is missing");
    }

    [Fact]
    public void Report_still_of_a_missing_frame_is_a_data_error()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);

        CliRun.Of("report", folder.Path, "--still", "7").AssertFailed(ExitCode.BadData, $"'{folder.Path}' has no frame 7. It is empty.");
    }

    [Theory]
    [InlineData("page.png")]
    [InlineData("frame.jpg", "--still", "7")]
    [InlineData("frame", "--still", "7")]
    public void Report_to_a_file_with_the_wrong_extension_is_refused(string file, params string[] still)
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);

        CliRun
            .Of(["report", folder.Path, "--out", folder.PathOf(file), .. still])
            .AssertFailed(ExitCode.Usage, "--out takes a file that ends in .");

        Assert.False(File.Exists(folder.PathOf(file)));
    }

    [Theory]
    [InlineData("--link")]
    [InlineData("--frames", "3")]
    public void Page_option_is_refused_for_a_still_image(params string[] option)
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);

        CliRun
            .Of(["report", folder.Path, "--still", "7", .. option])
            .AssertFailed(ExitCode.Usage, $"{option[0]} has no effect with --still.");
    }

    [Fact]
    public void Report_still_requires_a_frame_number() =>
        CliRun
            .Of("report", "session", "--still", "frame.png")
            .AssertFailed(ExitCode.Usage, "--still takes a frame number, e.g. 12, not 'frame.png'.");

    [Theory]
    [InlineData("0")]
    [InlineData("many")]
    public void Report_of_an_impossible_number_of_frames_is_a_usage_error(string frames) =>
        CliRun.Of("report", "session", "--frames", frames).AssertFailed(ExitCode.Usage, "--frames takes a whole number from 1");

    [Fact]
    public void Predictions_are_evaluated_and_shown()
    {
        using var folder = new TemporaryFolder();
        SharedHarvest.CopyTo(folder.PathOf("session"), "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
        string predictions = folder.File("predictions.json", "[]");
        string page = folder.PathOf("page.html");

        CliRun run = CliRun.Of("report", folder.PathOf("session"), "--predictions", predictions, "--out", page);

        run.AssertDone();
        Assert.Matches(@"\npredictions: AP 0\.000, AP50 0\.000, AP75 0\.000; 0 matched, \d+ missed, 0 false positives at", run.Out);
        Assert.Contains("id=\"predictions\"", File.ReadAllText(page), StringComparison.Ordinal);
    }

    [Fact]
    public void Bad_predictions_end_the_command_with_one_line()
    {
        using var folder = new TemporaryFolder();
        SharedHarvest.CopyTo(folder.PathOf("session"), "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
        string session = folder.PathOf("session");

        CliRun
            .Of("report", session, "--predictions", folder.File("bad.json", "[{}]"))
            .AssertFailed(ExitCode.BadData, "bad.json', line 1: image_id is missing");
        CliRun.Of("report", session, "--predictions", folder.PathOf("none.json")).AssertFailed(ExitCode.InputOutput, "none.json");
        CliRun.Of("report", session, "--min-score", "0.3").AssertFailed(ExitCode.Usage, "--min-score has no effect without --predictions.");
    }
}
