using System.Text.Json;

namespace Harvester.Cli.Tests.Commands;

public sealed class DriveCommandTests
{
    [Theory]
    [InlineData("stanley")]
    [InlineData("deepdriving")]
    [Trait("Category", "Heavy")]
    public void Drive_writes_reproducible_figures_and_report(string controller)
    {
        using TemporaryFolder folder = new();
        CliRun run = Drive(folder.PathOf("one"), controller);
        CliRun again = Drive(folder.PathOf("two"), controller);

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(
            Figures(run).Select(line => line.Replace(folder.PathOf("one"), folder.PathOf("two"), StringComparison.Ordinal)),
            Figures(again)
        );
        foreach (string file in new[] { "drive.json", "report.html" })
        {
            Assert.Equal(File.ReadAllBytes(folder.PathOf($"one/{file}")), File.ReadAllBytes(folder.PathOf($"two/{file}")));
        }

        using JsonDocument record = JsonDocument.Parse(File.ReadAllText(folder.PathOf("one/drive.json")));
        Assert.Equal(controller, record.RootElement.GetProperty("settings").GetProperty("controller").GetString());
        JsonElement figures = record.RootElement.GetProperty("figures");
        const double littleMore = 3;
        Assert.InRange(figures.GetProperty("metres").GetDouble(), 250, 250 + littleMore);
        Assert.InRange(figures.GetProperty("controllerMetres").GetDouble(), 80, 250);
        Assert.Equal(0, figures.GetProperty("collisions").GetInt32());
        Assert.Contains("<polyline class=\"controller\"", File.ReadAllText(folder.PathOf("one/report.html")), StringComparison.Ordinal);
    }

    [Fact]
    public void Drive_without_an_output_folder_is_refused() => CliRun.Of("drive").AssertFailed(2, "'--out' is required");

    [Fact]
    public void Drive_by_an_unknown_controller_is_refused() =>
        CliRun
            .Of("drive", "--out", "unused", "--controller", "nobody")
            .AssertFailed(2, "--controller takes stanley or deepdriving, not 'nobody'.");

    [Fact]
    public void Drive_from_an_invalid_place_is_refused() =>
        CliRun.Of("drive", "--out", "unused", "--near", "here").AssertFailed(2, "--near takes two numbers, e.g. 0,-1000, not 'here'.");

    [Fact]
    public void Drive_over_a_drive_requires_overwrite_and_then_replaces_it()
    {
        using TemporaryFolder folder = new();
        string drive = folder.PathOf("drive");
        Short(drive);
        File.WriteAllText(Path.Combine(drive, "drive.json"), "the first");

        Short(drive).AssertFailed(2, "already has a drive. Name another folder with --out, or replace it with --overwrite.");
        Assert.Equal("the first", File.ReadAllText(Path.Combine(drive, "drive.json")));
        Assert.Equal(0, Short(drive, "--overwrite").ExitCode);
        Assert.NotEqual("the first", File.ReadAllText(Path.Combine(drive, "drive.json")));
    }

    [Theory]
    [InlineData("session.json")]
    [InlineData("notes.txt")]
    public void Drive_always_refuses_a_folder_that_holds_other_files(string file)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.PathOf(file), "mine");

        Short(folder.PathOf(""), "--overwrite").AssertFailed(2, $"has files that are not a drive's, e.g. '{file}'");
        Assert.Equal("mine", File.ReadAllText(folder.PathOf(file)));
        Assert.Single(Directory.GetFiles(folder.PathOf("")));
    }

    [Fact]
    public void Drive_into_a_file_is_refused()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.PathOf("mine"), "mine");

        Short(folder.PathOf("mine")).AssertFailed(3, "is a file. Name a folder with --out.");
    }

    [Fact]
    public async Task Cancelled_drive_reports_its_progress()
    {
        using TemporaryFolder folder = new();
        using CancellationTokenSource cancelled = new();
        await cancelled.CancelAsync();

        CliRun run = await CliRun.StartAsync("", cancelled.Token, "drive", "--out", folder.PathOf("drive"), "--distance", "1000");

        Assert.Equal(130, run.ExitCode);
        Assert.Contains("Stopped after 0 of 1000 m.", run.Out, StringComparison.Ordinal);
        using JsonDocument record = JsonDocument.Parse(File.ReadAllText(folder.PathOf("drive/drive.json")));
        Assert.False(record.RootElement.GetProperty("isWhole").GetBoolean());
        Assert.Equal("1000", record.RootElement.GetProperty("settings").GetProperty("distanceMetres").GetString());
    }

    [Fact]
    public void Drive_far_from_the_roads_of_a_generated_town_is_refused()
    {
        using TemporaryFolder folder = new();

        Short(folder.PathOf("drive"), "--near=100000,0").AssertFailed(2, "No road lies within 400 m of 100000, 0; choose another place.");
    }

    private static CliRun Short(string folder, params string[] more) =>
        CliRun.Of([.. new[] { "drive", "--out", folder, "--distance", "5", "--traffic", "0" }, .. more]);

    /// <summary>The printed lines without those of the progress, whose number depends on the machine's speed.</summary>
    private static IEnumerable<string> Figures(CliRun run) =>
        run.Out.Split('\n').Where(line => !line.Contains(" of 250 m", StringComparison.Ordinal));

    private static CliRun Drive(string folder, string controller) =>
        CliRun.Of("drive", "--out", folder, "--controller", controller, "--distance", "250", "--traffic", "0.3", "--noise", "--seed", "6");
}
