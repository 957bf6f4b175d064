using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests;

/// <summary>The output of one run of the command within the test's process.</summary>
internal sealed record CliRun(int ExitCode, string Out, string Error)
{
    public static CliRun Of(params string[] arguments) => WithInput("", arguments);

    public static CliRun WithInput(string input, params string[] arguments) =>
        StartAsync(input, CancellationToken.None, arguments).GetAwaiter().GetResult();

    public static async Task<CliRun> StartAsync(string input, CancellationToken cancellation, params string[] arguments)
    {
        var output = new StringWriter { NewLine = "\n" };
        var error = new StringWriter { NewLine = "\n" };
        var terminal = new Terminal(new StringReader(input), output, error, IsInteractive: false);
        int code = await Application.RunAsync(arguments, terminal, cancellation);
        return new CliRun(code, output.ToString(), error.ToString());
    }

    /// <summary>The failure that every command promises: its exit code, nothing on standard output, one line on standard error.</summary>
    public void AssertFailed(int exitCode, string message)
    {
        Assert.Equal(exitCode, ExitCode);
        Assert.Contains(message, Error, StringComparison.Ordinal);
        Assert.StartsWith("harvester: ", Error, StringComparison.Ordinal);
        Assert.Equal(1, Error.Count(character => character == '\n'));
    }
}
