using System.CommandLine;
using System.CommandLine.Completions;
using System.CommandLine.Parsing;
using Harvester.Cli.Arguments;
using Harvester.Cli.Commands.Faces;
using Harvester.Cli.Commands.Logs;
using Harvester.Cli.Commands.Masks;
using Harvester.Cli.Commands.Plans;
using Harvester.Cli.Commands.Roads;
using Harvester.Cli.Commands.Scenarios;
using Harvester.Cli.Commands.Tapes;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Commands;

/// <summary>The harvester command: parses a command line, runs it, and turns every failure into one line and an exit code.</summary>
internal static class Application
{
    /// <summary>
    /// The runtime replaces bytes of an argument that are not valid UTF-8 by this character. The name of the file is then lost.
    /// </summary>
    private const string ReplacementCharacter = "\uFFFD";

    /// <summary>The word that asks for the help of the command that follows it, as --help after that command does.</summary>
    private const string Help = "help";

    private const string Description =
        "Harvests labelled driving images from a simulated game, and checks, shows and exports sessions, including those of the mod for "
        + "GTA V.";

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

    private static readonly (string Name, Func<Terminal, Command> Create)[] Commands =
    [
        ("harvest", HarvestCommand.Create),
        ("counterfactual", CounterfactualCommand.Create),
        ("plan", PlanCommand.Create),
        ("scenario", ScenarioCommand.Create),
        ("contact-sheet", ContactSheetCommand.Create),
        ("drive", DriveCommand.Create),
        ("serve", ServeCommand.Create),
        ("validate", ValidateCommand.Create),
        ("repair", RepairCommand.Create),
        ("doctor", DoctorCommand.Create),
        ("report", ReportCommand.Create),
        ("view", ViewCommand.Create),
        ("calibrate", CalibrateCommand.Create),
        ("stats", StatsCommand.Create),
        ("compare", CompareCommand.Create),
        ("relabel", RelabelCommand.Create),
        ("export", ExportCommand.Create),
        ("pairs", PairsCommand.Create),
        ("merge", MergeCommand.Create),
        ("rebuild", RebuildCommand.Create),
        ("supervise", SuperviseCommand.Create),
        ("project", ProjectCommand.Create),
        ("boxes", BoxesCommand.Create),
        ("masks", MasksCommand.Create),
        ("roads", RoadsCommand.Create),
        ("log", LogCommand.Create),
        ("lanes", LanesCommand.Create),
        ("spaces", SpacesCommand.Create),
        ("tape", TapeCommand.Create),
    ];

    /// <summary>Runs one command line.</summary>
    /// <param name="arguments">The command-line arguments, without the name of the program.</param>
    /// <param name="terminal">Standard input, output and error.</param>
    /// <param name="cancellation">Stops a long command cleanly, as Ctrl+C does.</param>
    /// <returns>The exit code.</returns>
    public static async Task<int> RunAsync(string[] arguments, Terminal terminal, CancellationToken cancellation)
    {
        if (arguments is [Help, .. var asked])
        {
            return await RunAsync([.. asked, "--help"], terminal, cancellation).ConfigureAwait(false);
        }

        Option<bool> quiet = QuietOption.Create();
        ParseResult parsed = CreateRoot(terminal, quiet, arguments).Parse(arguments);
        if (FaultIn(parsed, arguments) is { } fault)
        {
            return Fail(terminal, ExitCode.Usage, $"{fault} See '{HelpOf(parsed.CommandResult)}'.");
        }

        Terminal chosen = QuietOption.TerminalFor(parsed, quiet, terminal);
        return await RunAsync(chosen == terminal ? parsed : CreateRoot(chosen, quiet, arguments).Parse(arguments), chosen, cancellation)
            .ConfigureAwait(false);
    }

    /// <summary>Parses a command line without running it, and without reading response files.</summary>
    /// <param name="arguments">The command-line arguments, without the name of the program.</param>
    /// <param name="terminal">Receives nothing; the commands are made for it.</param>
    /// <exception cref="UsageException">It is not a command of this program.</exception>
    public static ParseResult Parse(string[] arguments, Terminal terminal)
    {
        var plain = new ParserConfiguration { ResponseFileTokenReplacer = null };
        ParseResult parsed = CreateRoot(terminal, QuietOption.Create(), arguments).Parse(arguments, plain);
        return FaultIn(parsed, arguments) is { } fault ? throw new UsageException(fault) : parsed;
    }

    private static async Task<int> RunAsync(ParseResult parsed, Terminal terminal, CancellationToken cancellation)
    {
        var configuration = new InvocationConfiguration
        {
            Output = terminal.Out,
            Error = terminal.Error,
            EnableDefaultExceptionHandler = false,
            // Signals arrive through the cancellation token.
            ProcessTerminationTimeout = null,
        };
        try
        {
            OutputOverInput.Check(parsed);
            int code = await parsed.InvokeAsync(configuration, cancellation).ConfigureAwait(false);
            await terminal.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
            return code;
        }
        catch (Exception e) when (e is UsageException or OccupiedFolderException or FolderLockedException)
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
        catch (LowSpaceException e)
        {
            return Fail(
                terminal,
                ExitCode.InputOutput,
                $"{e.Message} What was written is whole. Free some space. {OptionAdvice.OnLowSpace}"
            );
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return Fail(terminal, ExitCode.InputOutput, FileFault.TextOf(e, OutputOf(parsed)));
        }
        catch (OperationCanceledException)
        {
            string next = parsed.CommandResult.Command.Options.Any(option => option.Name == ResumeOption.Name)
                ? " To continue, give the same command with --resume."
                : "";
            return Fail(terminal, ExitCode.Cancelled, "Stopped." + next);
        }
        catch (Exception e)
        {
            // Any exception that is not handled above is a fault of the program.
            return Fail(terminal, ExitCode.ProgramFault, FaultReport.Write(e));
        }
    }

    /// <summary>What is wrong with a command line; null if it can be run.</summary>
    private static string? FaultIn(ParseResult parsed, string[] arguments)
    {
        if (Array.IndexOf(arguments, "") >= 0)
        {
            return "A value on the command line is empty.";
        }

        if (Array.Find(arguments, argument => argument.Contains(ReplacementCharacter, StringComparison.Ordinal)) is { } unreadable)
        {
            return $"'{unreadable}' is not valid UTF-8. Rename the file or folder so that its name is.";
        }

        return StrayOption(parsed, arguments) is { } stray ? Unrecognised(stray, parsed)
            : parsed.Errors.Count > 0 && !IsCompletion(parsed) ? MessageOf(parsed)
            : null;
    }

    /// <summary>All commands; if the first argument is one of them, only that one, because making options takes time.</summary>
    private static RootCommand CreateRoot(Terminal terminal, Option<bool> quiet, string[] arguments)
    {
        var root = new RootCommand(Description);
        root.Options.Add(quiet);
        string first = arguments.Length > 0 ? arguments[0] : "";
        bool isNamed = Array.Exists(Commands, command => command.Name == first);
        foreach ((string name, Func<Terminal, Command> create) in Commands)
        {
            if (!isNamed || name == first)
            {
                root.Subcommands.Add(create(terminal));
            }
        }

        HelpWithNotes.AddTo(root, ExitCodes);
        return root;
    }

    /// <summary>Whether the shell asks for completions.</summary>
    private static bool IsCompletion(ParseResult parsed) =>
        parsed.RootCommandResult.Children.OfType<DirectiveResult>().Any(directive => directive.Directive is SuggestDirective);

    private static string MessageOf(ParseResult parsed)
    {
        if (parsed.UnmatchedTokens.Count > 0)
        {
            return Unrecognised(parsed.UnmatchedTokens[0], parsed);
        }

        ParseError error = parsed.Errors[0];
        return error.SymbolResult switch
        {
            ArgumentResult { Tokens.Count: 0, Argument.Name: var argument, Parent: CommandResult } => $"{argument} is missing.",
            OptionResult { Tokens.Count: 0, Implicit: false, Option.Name: var option } => $"{option} needs a value.",
            OptionResult { Tokens.Count: > 1, Option.Name: var option } => $"{option} is given more than once.",
            CommandResult { Command.Subcommands.Count: > 0 } => "A command is missing.",
            _ => error.Message,
        };
    }

    /// <summary>
    /// A misspelt option that the parser took for the value of an argument; null if there is none. After a --, anything is a value.
    /// </summary>
    private static string? StrayOption(ParseResult parsed, string[] arguments) =>
        IsCompletion(parsed)
            ? null
            : parsed
                .CommandResult.Children.OfType<ArgumentResult>()
                .SelectMany(argument => argument.Tokens)
                .Select(token => token.Value)
                .FirstOrDefault(word =>
                    word.StartsWith("--", StringComparison.Ordinal) && arguments.TakeWhile(each => each != "--").Contains(word)
                );

    private static string Unrecognised(string word, ParseResult parsed)
    {
        string suggestion = Suggestion.For(word, parsed.CommandResult) is { } meant ? $" Did you mean '{meant}'?" : "";
        return $"Unrecognised argument '{word}'.{suggestion}";
    }

    private static int Fail(Terminal terminal, int code, string message)
    {
        terminal.WriteError(message);
        try
        {
            // Results written before the failure are kept. If the disk is full, the line above says so already.
            terminal.Out.Flush();
        }
        catch (IOException)
        {
            return code;
        }

        return code;
    }

    /// <summary>The value of --out; null without it.</summary>
    private static string? OutputOf(ParseResult parsed) =>
        parsed.CommandResult.Children.OfType<OptionResult>().FirstOrDefault(option => option.Option.Name == "--out")
            is { Tokens: [{ Value: var place }, ..] }
            ? place
            : null;

    private static string HelpOf(CommandResult command) => $"harvester {PathOf(command)}--help";

    private static string PathOf(CommandResult command) =>
        command.Parent is CommandResult parent ? $"{PathOf(parent)}{command.Command.Name} " : "";
}
