using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario: works with scenarios, situations in traffic that are staged.</summary>
internal static class ScenarioCommand
{
    private const string Notes =
        "A scenario names actors, where they begin, and what they do when. docs/scenarios.md describes the file and the library in\n"
        + "data/scenarios.\n\n"
        + "Examples:\n"
        + "  harvester scenario check data/scenarios/cut-in-left.json\n"
        + "  harvester scenario show data/scenarios/cut-in-left.json\n"
        + "  harvester scenario run data/scenarios/cut-in-left.json --out out";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("scenario", "Check, show, stage and exchange situations in traffic.");
        command.Subcommands.Add(ScenarioCheckCommand.Create(terminal));
        command.Subcommands.Add(ScenarioShowCommand.Create(terminal));
        command.Subcommands.Add(ScenarioRunCommand.Create(terminal));
        command.Subcommands.Add(ScenarioExportCommand.Create(terminal));
        command.Subcommands.Add(ScenarioImportCommand.Create(terminal));
        HelpWithNotes.AddTo(command, Notes);
        return command;
    }

    /// <summary>Reads a scenario that has no problem.</summary>
    /// <exception cref="DatasetFormatException">It has a problem; the first is named.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static ScenarioTemplate Read(FileInfo file)
    {
        ScenarioReading reading = ScenarioParser.Read(InputFile.ReadAllText(file.FullName));
        return reading.Template
            ?? throw new DatasetFormatException(
                $"'{file}': {reading.Problems[0]}"
                    + (reading.Problems.Count > 1 ? $" {reading.Problems.Count - 1} more: harvester scenario check lists all." : "")
            );
    }

    /// <summary>The argument of the commands that read one scenario.</summary>
    public static Argument<FileInfo> FileArgument() => new("FILE") { Description = "The scenario, a JSON file" };
}
