using System.Text.Json;

namespace Harvester.Cli.Tests.Commands;

public sealed class DriveCommandTests
{
    [Theory]
    [InlineData("stanley")]
    [InlineData("deepdriving")]
    public void Drive_writes_figures_and_report_and_the_same_again(string controller)
    {
        using TemporaryFolder folder = new();
        CliRun run = Drive(folder.PathOf("one"), controller);
        CliRun again = Drive(folder.PathOf("two"), controller);

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(run.Out.Replace("one", "two", StringComparison.Ordinal), again.Out);
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
    public void Drive_to_no_folder_is_refused() => CliRun.Of("drive").AssertFailed(2, "'--out' is required");

    [Fact]
    public void Drive_by_nobody_known_is_refused() =>
        CliRun.Of("drive", "--out", "unused", "--controller", "nobody").AssertFailed(2, "--controller takes stanley or deepdriving, not 'nobody'.");

    [Fact]
    public void Drive_from_no_place_is_refused() =>
        CliRun.Of("drive", "--out", "unused", "--near", "here").AssertFailed(2, "--near takes two numbers, not 'here'.");

    private static CliRun Drive(string folder, string controller) =>
        CliRun.Of("drive", "--out", folder, "--controller", controller, "--distance", "250", "--traffic", "0.3", "--noise", "--seed", "4");
}
