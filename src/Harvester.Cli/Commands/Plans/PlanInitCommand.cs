using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan init: writes an example of a plan.</summary>
internal static class PlanInitCommand
{
    /// <summary>A plan that runs anywhere in a few minutes.</summary>
    internal const string Example = """
        {
          "name": "example",
          "seed": 1,
          "places": [
            {"name": "town", "spread": 3},
            {"name": "stop", "space": "STOP", "metresBefore": 60, "metres": 80}
          ],
          "weathers": ["clear", "rain"],
          "hours": ["12:00", "21:00"],
          "cameras": [
            {"name": "front", "width": 800, "height": 600, "verticalFovDegrees": 50}
          ],
          "repetitions": 1,
          "frames": 40,
          "hz": 5,
          "speed": 12,
          "traffic": 1,
          "pedestrians": 1,
          "parked": 1,
          "masks": "off"
        }

        """;

    private const string Notes =
        "The file is complete: every field has its default or an example. docs/plans.md describes the fields.\n\n"
        + "Example:\n"
        + "  harvester plan init plan.json";

    public static Command Create(Terminal terminal)
    {
        var file = new Argument<FileInfo>("FILE")
        {
            Description = "The file to write",
            DefaultValueFactory = _ => new FileInfo(PlanResults.PlanCopy),
        };
        var command = new Command("init", "Write an example of a plan.") { file };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(file))));
        return command;
    }

    private static int Run(Terminal terminal, FileInfo file)
    {
        if (!AtomicFile.TryWriteNew(file.FullName, Example.ReplaceLineEndings("\n")))
        {
            throw new UsageException($"'{file}' exists already. Name another file.");
        }

        terminal.Out.WriteLine($"plan     {file}");
        terminal.Out.WriteLine($"next     harvester plan show {ShellWord.Of(file.ToString())}");
        return ExitCode.Done;
    }
}
