using System.Text;
using Harvester.Runs.Faults;
using Harvester.Runs.Ports;
using Spectre.Console;

namespace Harvester.Cli.Terminals;

/// <summary>The streams of a command: those of the process, or those of a test.</summary>
/// <param name="In">Standard input.</param>
/// <param name="Out">Standard output: results.</param>
/// <param name="Error">Standard error: messages, one line each.</param>
/// <param name="IsInteractive">Whether the output goes to a terminal, so that it may have progress bars and colours.</param>
internal sealed record Terminal(TextReader In, TextWriter Out, TextWriter Error, bool IsInteractive) : IRunLog
{
    /// <summary>Columns of output that goes to a file or pipe.</summary>
    private const int PlainWidth = 120;

    /// <summary>The streams of the process, with UTF-8 and line feeds on every system.</summary>
    public static Terminal OfProcess()
    {
        var utf8 = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
        if (!Console.IsOutputRedirected)
        {
            Console.OutputEncoding = utf8;
        }

        var output = new StreamWriter(Console.OpenStandardOutput(), utf8) { AutoFlush = !Console.IsOutputRedirected, NewLine = "\n" };
        return new Terminal(new StreamReader(Console.OpenStandardInput(), utf8), output, Console.Error, !Console.IsOutputRedirected);
    }

    /// <summary>
    /// Writes a message to standard error. Messages quote the content of files, which may be hostile: control characters, which a terminal
    /// would obey, are removed, and long messages are truncated.
    /// </summary>
    public void WriteError(string message) => Error.WriteLine($"harvester: {MessageLine.Of(message)}");

    /// <summary>Writes a line of results that quotes files, without control characters as in <see cref="WriteError"/>.</summary>
    public void WriteQuoting(string line) => Out.WriteLine(string.Concat(line.Where(character => !char.IsControl(character))));

    /// <inheritdoc/>
    public void Note(string line)
    {
        WriteQuoting(line);
        Out.Flush();
    }

    /// <inheritdoc/>
    public void Warn(string message) => WriteError(message);

    /// <summary>A console for tables and progress on the same output; without colours and motion if it is not interactive.</summary>
    public IAnsiConsole ToAnsiConsole()
    {
        IAnsiConsole console = AnsiConsole.Create(
            new AnsiConsoleSettings
            {
                Out = new AnsiConsoleOutput(Out),
                Ansi = IsInteractive ? AnsiSupport.Detect : AnsiSupport.No,
                ColorSystem = IsInteractive ? ColorSystemSupport.Detect : ColorSystemSupport.NoColors,
                Interactive = IsInteractive ? InteractionSupport.Detect : InteractionSupport.No,
            }
        );
        if (!IsInteractive)
        {
            console.Profile.Width = PlainWidth;
        }

        return console;
    }
}
