using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>What the harvest command rejects, and what it leaves unchanged then.</summary>
public sealed class HarvestRefusalTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("--freeze", "slow", "--freeze takes paused, timeScale or auto, not 'slow'.")]
    [InlineData("--date", "02-30", "--date takes a day of the year, e.g. 12-21, not '02-30'.")]
    [InlineData("--detail", "best", "--detail takes plain or full, not 'best'.")]
    [InlineData("--quirks", "pause.heldCamera", "--quirks takes a comma-separated list of lag=N, ")]
    [InlineData("--quirks", "paused.lag=2", "--quirks takes a comma-separated list of lag=N, ")]
    public void Harvest_refuses_an_unknown_freeze_method(string option, string value, string message)
    {
        CliRun run = Harvest(Session, option, value);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Session));
    }

    [Theory]
    [InlineData(7)]
    [InlineData(40)]
    public void Harvest_with_excessive_picture_lag_fails_without_a_folder(int lag)
    {
        Harvest(Session, "--frames", "2", "--seed", "3", "--hz", "2", "--quirks", $"lag={lag}")
            .AssertFailed(
                ExitCode.HarvestFault,
                $"The image is {lag} ticks behind the game; the harvest allows 4. To allow more, raise --max-picture-lag."
            );

        Assert.False(Directory.Exists(Session));
    }

    [Theory]
    [InlineData("")]
    [InlineData("/below")]
    public void Harvest_into_a_file_is_refused(string below)
    {
        File.WriteAllText(_folder.PathOf("file"), "mine");

        Harvest(_folder.PathOf("file") + below).AssertFailed(ExitCode.InputOutput, "file' is a file. Name a folder with --out.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_into_a_session_requires_overwrite_to_replace_it()
    {
        Harvest(Session, "--frames", "2");

        Harvest(Session, "--frames", "1").AssertFailed(ExitCode.Usage, "--overwrite");
        Assert.Equal(2, new SessionReader(Session).ReadLabels().Count());

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1", "--overwrite").ExitCode);
        Assert.Single(Directory.GetFiles(Path.Combine(Session, "frames")));
    }

    [Fact]
    public void Harvest_that_cannot_start_keeps_the_session_to_overwrite()
    {
        Harvest(Session, "--frames", "1");

        CliRun run = Harvest(Session, "--overwrite", "--roads", _folder.PathOf("nowhere.zip"));

        Assert.Equal(ExitCode.InputOutput, run.ExitCode);
        Assert.Single(new SessionReader(Session).ReadLabels());
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_into_a_session_with_other_files_leaves_both()
    {
        Harvest(Session, "--frames", "1");
        string notes = Path.Combine(Session, "notes.txt");
        File.WriteAllText(notes, "mine");

        Harvest(Session, "--overwrite").AssertFailed(ExitCode.Usage, "'notes.txt'");

        Assert.True(File.Exists(notes));
        Assert.Single(new SessionReader(Session).ReadLabels());
    }

    [Fact]
    public void Harvest_never_replaces_a_folder_that_is_not_a_session()
    {
        _folder.File("precious.txt", "mine");

        Harvest(_folder.Path, "--overwrite").AssertFailed(ExitCode.Usage, "has no session");

        Assert.True(File.Exists(_folder.PathOf("precious.txt")));
    }

    [Theory]
    [InlineData("harvest", "800", "32 to 8192 each, e.g. 800x600, not '800'")]
    [InlineData("serve", "8x8", "32 to 8192 each")]
    [InlineData("calibrate", "800", "288x216 to 8192x8192, e.g. 800x600, not '800'")]
    [InlineData("project", "800", "1 to 65535 each")]
    public void Impossible_size_is_refused_with_the_limits_of_the_command(string command, string size, string limits) =>
        CliRun.Of([command, "--size", size, .. Required(command)]).AssertFailed(ExitCode.Usage, limits);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_with_a_view_too_wide_to_check_names_the_options()
    {
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            Session,
            "--frames",
            "1",
            "--size",
            "320x240",
            "--seed",
            "4",
            "--fov",
            "170",
            "--no-report"
        );

        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Contains(
            "The field of view is set by --fov. To skip this check, add --max-camera-error 0.",
            run.Error,
            StringComparison.Ordinal
        );
        Assert.DoesNotContain("ini", run.Error, StringComparison.Ordinal);
        Assert.Equal(
            ExitCode.Done,
            CliRun
                .Of(
                    "harvest",
                    "--out",
                    Session,
                    "--frames",
                    "1",
                    "--size",
                    "320x240",
                    "--seed",
                    "4",
                    "--fov",
                    "170",
                    "--no-report",
                    "--max-camera-error",
                    "0"
                )
                .ExitCode
        );
    }

    [Theory]
    [InlineData("--frames", "0")]
    [InlineData("--frames", "many")]
    [InlineData("--seed", "-1")]
    [InlineData("--size", "8x8")]
    [InlineData("--size", "31x300")]
    [InlineData("--size", "300x31")]
    [InlineData("--size", "65535x65535")]
    [InlineData("--size", "0x600")]
    [InlineData("--fov", "180")]
    [InlineData("--k1", "2")]
    [InlineData("--centre-offset", "2,0")]
    [InlineData("--max-camera-error", "-1")]
    [InlineData("--fov", "0.5")]
    [InlineData("--range", "1e300")]
    [InlineData("--hz", "0")]
    [InlineData("--hz", "61")]
    [InlineData("--range", "0")]
    [InlineData("--weather", "sunshine")]
    [InlineData("--quirks", "lag")]
    [InlineData("--max-picture-lag", "61")]
    [InlineData("--quirks", "lag=2,lateCamera=1")]
    [InlineData("--quirks", "vanish=1.5")]
    [InlineData("--time", "25:00")]
    [InlineData("--time", "noon")]
    [InlineData("--near", "1")]
    [InlineData("--classes", "car,plane")]
    public void Harvest_with_an_impossible_value_fails_and_writes_nothing(string option, string value)
    {
        CliRun.Of("harvest", "--out", Session, option, value).AssertFailed(ExitCode.Usage, option);

        Assert.False(Directory.Exists(Session));
    }

    [Fact]
    public void Harvest_without_out_is_a_usage_error() => CliRun.Of("harvest").AssertFailed(ExitCode.Usage, "--out");

    [Fact]
    public void Harvest_with_a_missing_road_file_is_an_input_error()
    {
        CliRun run = Harvest(Session, "--roads", "no-such-roads.zip");

        Assert.Equal(ExitCode.InputOutput, run.ExitCode);
        Assert.Contains("no-such-roads.zip", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_with_an_invalid_road_file_is_a_data_error()
    {
        string roads = _folder.File("roads.json", "not roads");

        CliRun run = Harvest(Session, "--roads", roads);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("roads.json", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_with_an_invalid_prop_file_is_a_data_error() =>
        Harvest(Session, "--props", _folder.File("lamps.json", "{}")).AssertFailed(ExitCode.BadData, "lamps.json");

    private static CliRun Harvest(string session, params string[] arguments) =>
        CliRun.Of(["harvest", "--out", session, "--size", "160x120", .. arguments]);

    /// <summary>Required arguments of a command besides the size.</summary>
    private string[] Required(string command) =>
        command switch
        {
            "harvest" => ["--out", Session],
            "project" => ["--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50"],
            _ => [],
        };
}
