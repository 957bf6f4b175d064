using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Runs.Plans;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan show: lists the trials of a plan and estimates what they take.</summary>
internal sealed class PlanShowCommand
{
    private const string Notes =
        "Prints a line for each trial: number, id, images, where it begins, and its seed. The last line estimates images, time and\n"
        + "size from the figures in docs/performance.md; nothing is measured. A drive that ends early takes fewer.\n\n"
        + "Example:\n"
        + "  harvester plan show plan.json";

    private PlanWorldOptions World { get; } = new();

    public static Command Create(Terminal terminal) => new PlanShowCommand().Build(terminal);

    private ResultCommand Build(Terminal terminal)
    {
        Argument<FileInfo> plan = PlanCommand.PlanArgument();
        var command = new ResultCommand("show", "List the trials of a plan and estimate frames, time and size.") { plan };
        World.AddTo(command);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(plan), World.Parse(parsed))));
        return command;
    }

    private static int Run(Terminal terminal, FileInfo plan, PlanWorld world)
    {
        PlanFile file = PlanFile.Read(plan.FullName);
        IReadOnlyList<Trial> trials = TrialList.Of(file.Plan, world.PlacesOf(file.Plan));
        for (int i = 0; i < trials.Count; i++)
        {
            Trial trial = trials[i];
            string start = trial.Place.Start is { } point ? FormattableString.Invariant($"{point.X:0.#},{point.Y:0.#}") : "any place";
            string images = Counted.Of(PlanRun.ImagesOf(file, trial), "image");
            terminal.Out.WriteLine(
                FormattableString.Invariant($"{i + 1}  {trial.Id}  {images}  at {start}  seed {trial.SeedOf(file.Plan.Seed, 1)}")
            );
        }

        string estimate = PlanEstimate.Of(file, trials).ToString();
        terminal.Out.WriteLine($"{Counted.Of(trials.Count, "trial")}: {estimate}, by the figures of docs/performance.md");
        return ExitCode.Done;
    }
}
