namespace Harvester.Cli.Tests;

public sealed class ApplicationTests
{
    [Fact]
    public void Help_lists_commands_and_exit_codes()
    {
        CliRun run = CliRun.Of("--help");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        foreach (string command in (string[])["harvest", "validate", "report", "project", "boxes"])
        {
            Assert.Contains($"\n  {command} ", run.Out, StringComparison.Ordinal);
        }

        Assert.Contains("130  stopped by Ctrl+C", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("harvest")]
    [InlineData("validate")]
    [InlineData("report")]
    [InlineData("project")]
    [InlineData("boxes")]
    public void Help_of_a_command_ends_with_an_example(string command)
    {
        CliRun run = CliRun.Of(command, "--help");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("Example", run.Out, StringComparison.Ordinal);
        Assert.Contains($"  harvester {command}", run.Out.Replace("echo 0,10,0 | ", "", StringComparison.Ordinal), StringComparison.Ordinal);
    }

    [Fact]
    public void No_command_is_a_usage_error() => CliRun.Of().AssertFailed(ExitCode.Usage, "harvester --help");

    [Fact]
    public void Unknown_command_is_a_usage_error() => CliRun.Of("harvset").AssertFailed(ExitCode.Usage, "harvset");

    [Fact]
    public void Unknown_option_is_a_usage_error_that_names_the_commands_help() =>
        CliRun.Of("boxes", "scene.json", "--depth").AssertFailed(ExitCode.Usage, "harvester boxes --help");
}
