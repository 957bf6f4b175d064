using System;
using System.IO;
using System.Linq;
using System.Text;
using Spectre.Console;

namespace Harvester.Cli.Terminals;

/// <summary>Where a command reads and writes: the process's own streams, or a test's.</summary>
/// <param name="In">Standard input.</param>
/// <param name="Out">Standard output: results.</param>
/// <param name="Error">Standard error: one line for what went wrong.</param>
/// <param name="IsInteractive">Whether a person watches the output, so that it may move and have colours.</param>
internal sealed record Terminal(TextReader In, TextWriter Out, TextWriter Error, bool IsInteractive)
{
    /// <summary>A width for output that goes to a file or pipe, which has none of its own.</summary>
    private const int PlainWidth = 120;
    private const int MaxErrorLength = 600;

    /// <summary>The process's own streams, UTF-8 and line feeds on every system.</summary>
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
    /// Says in one line what went wrong. Messages quote files, which may be anything: control characters, which a terminal would obey, are
    /// left out, and what is too long to read is cut.
    /// </summary>
    public void WriteError(string message) => Error.WriteLine($"harvester: {OneLine(message)}");

    /// <summary>A text that may be anything as one line of bounded length, without control characters.</summary>
    public static string OneLine(string text)
    {
        string line = string.Join(' ', text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        line = string.Concat(line.Where(character => !char.IsControl(character)));
        return line.Length <= MaxErrorLength ? line : line[..MaxErrorLength] + "...";
    }

    /// <summary>Tables and progress over the same output; without colours and motion when nobody watches.</summary>
    public IAnsiConsole ToAnsiConsole()
    {
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Out = new AnsiConsoleOutput(Out),
            Ansi = IsInteractive ? AnsiSupport.Detect : AnsiSupport.No,
            ColorSystem = IsInteractive ? ColorSystemSupport.Detect : ColorSystemSupport.NoColors,
            Interactive = IsInteractive ? InteractionSupport.Detect : InteractionSupport.No,
        });
        if (!IsInteractive)
        {
            console.Profile.Width = PlainWidth;
        }

        return console;
    }
}
