using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests;

/// <summary>The output of one run of the command within the test's process.</summary>
internal sealed record CliRun(int ExitCode, string Out, string Error)
{
    public static CliRun Of(params string[] arguments) => WithInput("", arguments);

    public static CliRun WithInput(string input, params string[] arguments) =>
        StartAsync(input, CancellationToken.None, arguments).GetAwaiter().GetResult();

    /// <summary>
    /// Runs a command beside the test, on a thread of its own. A thread of the pool would be blocked by the command for all its time, and
    /// the pool of a busy machine has no others for what the test and the command wait for.
    /// </summary>
    public static Task<CliRun> BesideAsync(params string[] arguments) => BesideAsync(CancellationToken.None, arguments);

    public static Task<CliRun> BesideAsync(CancellationToken cancellation, params string[] arguments) =>
        Task.Factory.StartNew(
            () => StartAsync("", cancellation, arguments).GetAwaiter().GetResult(),
            CancellationToken.None,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default
        );

    public static async Task<CliRun> StartAsync(string input, CancellationToken cancellation, params string[] arguments)
    {
        var output = new StringWriter { NewLine = "\n" };
        var error = new StringWriter { NewLine = "\n" };
        var terminal = new Terminal(new StringReader(input), output, error, IsInteractive: false);
        int code = await Application.RunAsync(arguments, terminal, cancellation);
        return new CliRun(code, output.ToString(), error.ToString());
    }

    /// <summary>Asserts that the command ended normally.</summary>
    public void AssertDone() => Assert.True((ExitCode, Error) == (Cli.Terminals.ExitCode.Done, ""), $"Exit code {ExitCode}. {Error}{Out}");

    /// <summary>The failure that every command promises: its exit code, nothing on standard output, one line on standard error.</summary>
    public void AssertFailed(int exitCode, string message)
    {
        Assert.Equal(exitCode, ExitCode);
        Assert.Contains(message, Error, StringComparison.Ordinal);
        Assert.StartsWith("harvester: ", Error, StringComparison.Ordinal);
        Assert.Equal(1, Error.Count(character => character == '\n'));
    }
}
