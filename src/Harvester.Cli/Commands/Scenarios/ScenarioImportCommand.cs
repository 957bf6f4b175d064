using System.CommandLine;
using System.Text;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario import: reads a scenario of another program.</summary>
internal static class ScenarioImportCommand
{
    /// <summary>The greatest length of a scenario's name.</summary>
    private const int MaxNameLength = 30;

    private const string Notes =
        "Reads of ASAM OpenSCENARIO XML 1.x what scenario export writes: places in lanes relative to the entity Ego, speeds, changes of\n"
        + "lanes, and conditions on time, distance, time to collision, speed and other events. Anything else is named with its line, and\n"
        + "nothing is written; the exit code is then 1. The ego's place, catalogs and the road network are left out: scenario run chooses\n"
        + "roads and place.\n\n"
        + "Example:\n"
        + "  harvester scenario import cut-in-left.xosc --out cut-in-left.json";

    public static Command Create(Terminal terminal)
    {
        Argument<FileInfo> file = new("FILE") { Description = "OpenSCENARIO file, .xosc" };
        Option<FileInfo> written = new("--out")
        {
            Description = "Scenario to write, a JSON file",
            HelpName = "FILE",
            Required = true,
        };
        var command = new Command("import", "Read a scenario from OpenSCENARIO.") { file, written };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(file), parsed.GetRequiredValue(written).FullName))
        );
        return command;
    }

    private static int Run(Terminal terminal, FileInfo file, string written)
    {
        string made;
        try
        {
            made = OpenScenarioReader.Read(InputFile.ReadAllText(file.FullName), NameOf(file));
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{file}': {e.Message}", e);
        }

        OutputFile.Write(written, stream => stream.Write(Encoding.UTF8.GetBytes(made)));
        Scenario scenario = ScenarioParser.Read(made).Template!.Middle;
        terminal.Out.WriteLine($"{written}: {scenario.Actors.Count} actors, {scenario.Events.Count} events");
        return ExitCode.Done;
    }

    /// <summary>A file's name with hyphens for what a scenario's name may not have.</summary>
    private static string NameOf(FileInfo file)
    {
        string name = new([.. Path.GetFileNameWithoutExtension(file.Name).Select(c => char.IsAsciiLetterOrDigit(c) ? c : '-')]);
        return name.Length == 0 ? "imported" : name[..Math.Min(name.Length, MaxNameLength)];
    }
}
