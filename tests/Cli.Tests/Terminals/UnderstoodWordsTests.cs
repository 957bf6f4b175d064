using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Terminals;

/// <summary>Words that differ from the documented ones only in a way that leaves no doubt.</summary>
public sealed class UnderstoodWordsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("--weather", "Rain", "rain")]
    [InlineData("--masks", "RAYS", null)]
    [InlineData("--detail", "Full", null)]
    [InlineData("--classes", "Car,PEDESTRIAN", null)]
    [InlineData("--freeze", "TIMESCALE", "timeScale")]
    [Trait("Category", "Heavy")]
    public void Capitals_do_not_matter_in_a_harvest(string option, string value, string? recorded)
    {
        CliRun.Of("harvest", "--frames", "1", "--size", "80x60", "--no-report", "--out", _folder.PathOf("out"), option, value).AssertDone();

        Assert.Contains(recorded ?? "", File.ReadAllText(_folder.PathOf("out/session.json")), StringComparison.Ordinal);
    }

    [Fact]
    public void Capitals_do_not_matter_in_an_export()
    {
        SharedHarvest.CopyTo(_folder.PathOf("session"), "--frames", "1", "--size", "80x60", "--no-report");

        CliRun.Of("export", _folder.PathOf("session"), "--format", "COCO", "--map", "Bus=car", "--out", _folder.PathOf("out")).AssertDone();
    }

    [Theory]
    [InlineData("help")]
    [InlineData("help", "export")]
    [InlineData("help", "roads", "map")]
    public void Help_is_a_command_too(params string[] arguments)
    {
        CliRun run = CliRun.Of(arguments);

        run.AssertDone();
        Assert.Equal(CliRun.Of([.. arguments[1..], "--help"]).Out, run.Out);
    }

    [Theory]
    [InlineData(".png", "contact-sheet")]
    [InlineData(".html or .htm", "spaces", "gallery")]
    public void Output_of_another_kind_is_refused(string expected, params string[] command)
    {
        string table = _folder.PathOf("spaces.csv");
        File.WriteAllText(table, "");
        string[] source = command[0] == "spaces" ? [table] : [];

        CliRun
            .Of([.. command, .. source, "--out", _folder.PathOf("x.txt")])
            .AssertFailed(ExitCode.Usage, $"--out takes a file that ends in {expected}, not");

        Assert.False(File.Exists(_folder.PathOf("x.txt")));
    }
}
