using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario check: lists every problem of scenario files.</summary>
internal static class ScenarioCheckCommand
{
    private const string Notes =
        "Prints a line for each problem, which names the field. The exit code is 1 if there is one.\n\n"
        + "Example:\n"
        + "  harvester scenario check data/scenarios/merge.json";

    public static Command Create(Terminal terminal)
    {
        Argument<FileInfo[]> files = new("FILE") { Description = "Scenarios, JSON files", Arity = ArgumentArity.OneOrMore };
        var command = new ResultCommand("check", "List every problem of scenarios.") { files };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(files))));
        return command;
    }

    private static int Run(Terminal terminal, FileInfo[] files)
    {
        bool areValid = true;
        foreach (FileInfo file in files)
        {
            ScenarioReading reading = ScenarioParser.Read(InputFile.ReadAllText(file.FullName));
            foreach (string problem in reading.Problems)
            {
                terminal.WriteQuoting(files.Length == 1 ? problem : $"{file}: {problem}");
            }

            terminal.WriteQuoting(
                reading.Template is null ? $"{file}: {Counted.Of(reading.Problems.Count, "problem")}" : $"{file}: the scenario is valid"
            );
            areValid &= reading.Template is not null;
        }

        return areValid ? ExitCode.Done : ExitCode.BadData;
    }
}
