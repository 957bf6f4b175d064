using System.Text;
using System.Text.RegularExpressions;
using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>An unforeseen exception.</summary>
public sealed class FaultReportTests
{
    [Fact]
    public async Task Unforeseen_exception_asks_for_a_report_in_one_line()
    {
        var error = new StringWriter { NewLine = "\n" };
        var terminal = new Terminal(new StringReader("0,5,0\n"), new FailingWriter(), error, IsInteractive: false);

        int code = await Application.RunAsync(
            ["project", "--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50", "--size", "80x60"],
            terminal,
            CancellationToken.None
        );

        Assert.Equal(ExitCode.ProgramFault, code);
        Match line = Regex.Match(
            error.ToString(),
            "^harvester: Internal error: InvalidTimeZoneException. Please report it with " + "'(.*)', which has the details.\n$"
        );
        Assert.True(line.Success, error.ToString());
        string details = await File.ReadAllTextAsync(line.Groups[1].Value);
        Assert.Contains(nameof(FailingWriter), details, StringComparison.Ordinal);
        Directory.Delete(Path.GetDirectoryName(line.Groups[1].Value)!, recursive: true);
    }

    private sealed class FailingWriter : TextWriter
    {
        public override Encoding Encoding => Encoding.UTF8;

        public override void Write(char value) => throw new InvalidTimeZoneException();
    }
}
