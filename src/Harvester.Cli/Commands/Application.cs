using System;
using System.CommandLine;
using System.CommandLine.Completions;
using System.CommandLine.Parsing;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Commands.Faces;
using Harvester.Cli.Commands.Masks;
using Harvester.Cli.Commands.Roads;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;

namespace Harvester.Cli.Commands;

/// <summary>The harvester command: parses a command line, runs it, and turns every failure into one line and an exit code.</summary>
internal static class Application
{
    /// <summary>
    /// The runtime puts this in the place of bytes of an argument that are not UTF-8. The name of the file is then lost.
    /// </summary>
    private const string ReplacementCharacter = "\uFFFD";

    private const string Description =
        "Harvests labelled driving images from a simulated game, and checks, shows and exports sessions, also those of the mod for GTA V.";

    private const string ExitCodes =
        "Exit codes:\n"
        + "  0    success\n"
        + "  1    bad data: a session or log with problems, a malformed file\n"
        + "  2    error on the command line, including an output folder that is occupied or being written by another process\n"
        + "  3    a file cannot be read or written, or a bridge to another program failed\n"
        + "  4    the simulated game failed, or a calibration or harvest refused its result\n"
        + "  70   a fault of this program, to be reported; the message names a file with the details\n"
        + "  130  stopped by Ctrl+C (SIGINT); what was written is valid\n"
        + "  143  stopped by SIGTERM; what was written is valid\n\n"
        + "Tab completion for bash, zsh and PowerShell: docs/command-line.md";

    /// <summary>Runs one command line.</summary>
    /// <param name="arguments">The words after the command's name.</param>
    /// <param name="terminal">Where it reads and writes.</param>
    /// <param name="cancellation">Stops a long command cleanly, as Ctrl+C does.</param>
    /// <returns>The exit code.</returns>
    public static async Task<int> RunAsync(string[] arguments, Terminal terminal, CancellationToken cancellation)
    {
        Option<bool> quiet = QuietOption.Create();
        ParseResult parsed = CreateRoot(terminal, quiet).Parse(arguments);
        if (Array.IndexOf(arguments, "") >= 0)
        {
            return Fail(terminal, ExitCode.Usage, $"A value on the command line is empty. See '{HelpOf(parsed.CommandResult)}'.");
        }

        if (Array.Find(arguments, argument => argument.Contains(ReplacementCharacter, StringComparison.Ordinal)) is { } unreadable)
        {
            return Fail(terminal, ExitCode.Usage, $"'{unreadable}' is not valid UTF-8. Rename the file or folder so that its name is.");
        }

        if (parsed.Errors.Count > 0 && !IsCompletion(parsed))
        {
            return Fail(terminal, ExitCode.Usage, $"{MessageOf(parsed)} See '{HelpOf(parsed.CommandResult)}'.");
        }

        Terminal chosen = QuietOption.TerminalFor(parsed, quiet, terminal);
        return await RunAsync(chosen == terminal ? parsed : CreateRoot(chosen, quiet).Parse(arguments), chosen, cancellation)
            .ConfigureAwait(false);
    }

    private static async Task<int> RunAsync(ParseResult parsed, Terminal terminal, CancellationToken cancellation)
    {

        var configuration = new InvocationConfiguration
        {
            Output = terminal.Out,
            Error = terminal.Error,
            EnableDefaultExceptionHandler = false,
            // The process's signals come through the cancellation token.
            ProcessTerminationTimeout = null,
        };
        try
        {
            int code = await parsed.InvokeAsync(configuration, cancellation).ConfigureAwait(false);
            await terminal.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
            return code;
        }
        catch (Exception e) when (e is UsageException or OccupiedFolderException)
        {
            return Fail(terminal, ExitCode.Usage, $"{e.Message} See '{HelpOf(parsed.CommandResult)}'.");
        }
        catch (DatasetFormatException e)
        {
            return Fail(terminal, ExitCode.BadData, e.Message);
        }
        catch (GameFaultException e)
        {
            return Fail(terminal, ExitCode.HarvestFault, e.Message);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return Fail(terminal, ExitCode.InputOutput, FileFault.TextOf(e, OutputOf(parsed)));
        }
        catch (OperationCanceledException)
        {
            return Fail(terminal, ExitCode.Cancelled, "Stopped.");
        }
        catch (Exception e)
        {
            // What nobody thought of is a fault of the program, whatever it is.
            return Fail(terminal, ExitCode.ProgramFault, FaultReport.Write(e));
        }
    }

    private static RootCommand CreateRoot(Terminal terminal, Option<bool> quiet)
    {
        var root = new RootCommand(Description);
        root.Options.Add(quiet);
        root.Subcommands.Add(HarvestCommand.Create(terminal));
        root.Subcommands.Add(DriveCommand.Create(terminal));
        root.Subcommands.Add(ServeCommand.Create(terminal));
        root.Subcommands.Add(ValidateCommand.Create(terminal));
        root.Subcommands.Add(DoctorCommand.Create(terminal));
        root.Subcommands.Add(ReportCommand.Create(terminal));
        root.Subcommands.Add(CalibrateCommand.Create(terminal));
        root.Subcommands.Add(StatsCommand.Create(terminal));
        root.Subcommands.Add(RelabelCommand.Create(terminal));
        root.Subcommands.Add(ExportCommand.Create(terminal));
        root.Subcommands.Add(MergeCommand.Create(terminal));
        root.Subcommands.Add(ProjectCommand.Create(terminal));
        root.Subcommands.Add(BoxesCommand.Create(terminal));
        root.Subcommands.Add(MasksCommand.Create(terminal));
        root.Subcommands.Add(RoadsCommand.Create(terminal));
        root.Subcommands.Add(LanesCommand.Create(terminal));
        root.Subcommands.Add(SpacesCommand.Create(terminal));
        HelpWithNotes.AddTo(root, ExitCodes);
        return root;
    }

    /// <summary>Whether the command line asks how another one goes on.</summary>
    private static bool IsCompletion(ParseResult parsed) =>
        parsed.RootCommandResult.Children.OfType<DirectiveResult>().Any(directive => directive.Directive is SuggestDirective);

    private static string MessageOf(ParseResult parsed)
    {
        if (parsed.UnmatchedTokens.Count == 0)
        {
            return parsed.Errors[0].Message;
        }

        string word = parsed.UnmatchedTokens[0];
        string suggestion = Suggestion.For(word, parsed.CommandResult) is { } meant ? $" Did you mean '{meant}'?" : "";
        return $"Unrecognised argument '{word}'.{suggestion}";
    }

    private static int Fail(Terminal terminal, int code, string message)
    {
        terminal.WriteError(message);
        try
        {
            // What was written before the failure belongs to the reader; on a full disk there is no more to say than the line above.
            terminal.Out.Flush();
        }
        catch (IOException)
        {
            return code;
        }

        return code;
    }

    /// <summary>Where the command's output goes; null where that was not said.</summary>
    private static string? OutputOf(ParseResult parsed) =>
        parsed.CommandResult.Children.OfType<OptionResult>()
            .FirstOrDefault(option => option.Option.Name == "--out") is { Tokens: [{ Value: var place }, ..] } ? place : null;

    private static string HelpOf(CommandResult command) => $"harvester {PathOf(command)}--help";

    private static string PathOf(CommandResult command) =>
        command.Parent is CommandResult parent ? $"{PathOf(parent)}{command.Command.Name} " : "";
}
