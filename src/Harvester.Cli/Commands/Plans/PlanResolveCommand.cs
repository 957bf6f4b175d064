using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.Runs.Plans;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan resolve: writes a plan whose places are all chosen.</summary>
internal sealed class PlanResolveCommand
{
    private const string Notes =
        "The new plan has the same trials, with x and y in place of spread and space, and every other field in full. The mod needs\n"
        + "such a plan. Places for GTA V come from its road network, --roads.\n\n"
        + "Example:\n"
        + "  harvester plan resolve plan.json --roads data/example-roads.csv --out resolved.json";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "File to write the plan to",
            HelpName = "FILE",
            Required = true,
        };
    private PlanWorldOptions World { get; } = new();

    public static Command Create(Terminal terminal) => new PlanResolveCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        Argument<FileInfo> plan = PlanCommand.PlanArgument();
        var command = new Command("resolve", "Write a plan whose places are all chosen.") { plan, Out };
        command.Options.Add(World.Roads);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, _) =>
                Task.FromResult(Run(terminal, parsed.GetRequiredValue(plan), World.WithRoads(parsed), parsed.GetRequiredValue(Out)))
        );
        return command;
    }

    private static int Run(Terminal terminal, FileInfo file, PlanWorld world, string output)
    {
        Plan plan = PlanFile.Read(file.FullName).Plan;
        Plan resolved = plan with { Places = world.PlacesOf(plan) };
        if (PlanParser.Read(PlanJson.Of(resolved)).Problems is [var problem, ..])
        {
            throw new UsageException($"With all places chosen, the plan has a problem: {problem}");
        }

        if (!AtomicFile.TryWriteNew(Path.GetFullPath(output), PlanJson.Of(resolved)))
        {
            throw new UsageException($"'{output}' exists already. Name another file with --out.");
        }

        terminal.Out.WriteLine($"plan     {output}, {Counted.Of(resolved.Places.Count, "place")}");
        return ExitCode.Done;
    }
}
