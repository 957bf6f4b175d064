using System.CommandLine;
using System.Text;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario export: writes a scenario for other programs.</summary>
internal static class ScenarioExportCommand
{
    private const string Notes =
        "Writes ASAM OpenSCENARIO XML 1.2 with the values of a seed: starts on lanes relative to the ego, speeds, changes of lanes, and\n"
        + "conditions on time, distance, time to collision, speed and other events. What has no counterpart is named, and nothing is\n"
        + "written; the exit code is then 1. --roads names the OpenDRIVE file in the result; roads map writes one.\n\n"
        + "Example:\n"
        + "  harvester scenario export data/scenarios/cut-in-left.json --out cut-in-left.xosc";

    public static Command Create(Terminal terminal)
    {
        Argument<FileInfo> file = ScenarioCommand.FileArgument();
        Option<FileInfo> written = new("--out")
        {
            Description = "File to write, .xosc",
            HelpName = "FILE",
            Required = true,
        };
        Option<int> seed = ValueParsers.Integer("--seed", "N", "Seed from which the parameters are drawn", 0, int.MaxValue);
        seed.DefaultValueFactory = _ => 1;
        Option<string?> roads = new("--roads") { Description = "Path of the OpenDRIVE file, as the result has it", HelpName = "PATH" };
        var command = new Command("export", "Write a scenario as OpenSCENARIO.") { file, written, seed, roads };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, _) =>
                Task.FromResult(
                    Run(
                        terminal,
                        ScenarioCommand.Read(parsed.GetRequiredValue(file)).Drawn(parsed.GetValue(seed)),
                        parsed.GetRequiredValue(written).FullName,
                        parsed.GetValue(roads)
                    )
                )
        );
        return command;
    }

    private static int Run(Terminal terminal, Scenario scenario, string written, string? roads)
    {
        IReadOnlyList<string> problems = OpenScenarioWriter.Problems(scenario);
        if (problems.Count > 0)
        {
            throw new DatasetFormatException($"'{scenario.Name}' cannot be written as OpenSCENARIO. {string.Join(" ", problems)}");
        }

        string text = OpenScenarioWriter.Of(scenario, roads);
        OutputFile.Write(written, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        terminal.Out.WriteLine($"{written}: {scenario.Actors.Count} actors, {scenario.Events.Count} events");
        return ExitCode.Done;
    }
}
