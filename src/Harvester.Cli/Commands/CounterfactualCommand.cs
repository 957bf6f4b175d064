using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;

namespace Harvester.Cli.Commands;

/// <summary>harvester counterfactual: the same situation again with one thing changed.</summary>
internal sealed class CounterfactualCommand
{
    private const string Notes =
        "Harvests the folder base, and then once more for each --change: change-01, change-02 and so on. All runs agree to the byte up to\n"
        + "the moment of the change, in labels, images and everything else. counterfactuals.json names the changes, and harvester pairs\n"
        + "exports the frames side by side. All options of harvester harvest apply; docs/counterfactuals.md describes the changes.\n\n"
        + "Changes, several of one run separated by semicolons:\n"
        + "  frame 20: ego brakes 6          after frame 20, the driver brakes with 6 m/s2 to a stop and stands\n"
        + "  frame 20: 17 brakes 3 for 8     the driver of object 17 brakes and stands, 8 s in all\n"
        + "  12.5s: ego drives 15            from the game time 12.5 s on, the driver aims for 15 m/s\n"
        + "  frame 20: without 17            object 17, a vehicle in traffic or a person on foot, disappears\n"
        + "  frame 20: weather rain          it rains; with --crashes the road is slippery, too\n"
        + "Spaces may be underscores. A command that was stopped continues when it is given again.\n\n"
        + "Examples:\n"
        + "  harvester counterfactual --out brake --near 0,0 --frames 60 --crashes --change \"frame 20: ego brakes 6\"";

    private readonly HarvestCommand _harvest = new();

    private readonly Option<string[]> _changes = new("--change")
    {
        Description = "What is changed, and when: MOMENT: CHANGE, see below; repeatable, one run for each",
        HelpName = "CHANGE",
        Required = true,
    };

    public static Command Create(Terminal terminal) => new CounterfactualCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("counterfactual", "Harvest one situation several times, each time with one thing changed.") { _changes };
        _harvest.AddTo(command);
        HelpWithNotes.AddTo(command, Notes, [new OptionGroup("Changes", ["--change"]), .. OptionGroups.OfHarvest]);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        var runs = new CounterfactualRuns(parsed.GetValue(_changes) ?? []);
        HarvestPlan plan = _harvest.PlanOf(parsed);
        Check(plan, runs.Changes);
        return runs.Harvest(terminal, plan, CommandText.Of(parsed), _harvest.HasReport(parsed), cancellation);
    }

    private static void Check(HarvestPlan plan, IEnumerable<TimedChange> changes)
    {
        if (plan.Options.Places is { Count: > 1 })
        {
            throw new UsageException("Counterfactuals are of one place: add --places 1, or --near.");
        }

        if (plan.Overwrite || plan.Resume)
        {
            throw new UsageException(
                "--overwrite and --resume do not apply to counterfactuals: the same command continues what it left unfinished."
            );
        }

        if (plan.Options.Shard.Count > 1)
        {
            throw new UsageException("A shard has not all frames; --shard does not apply to counterfactuals.");
        }

        foreach (TimedChange change in changes)
        {
            if ((change.Actor ?? change.Event) is { } name)
            {
                throw new UsageException(
                    $"--change \"{change.Text}\": a harvest has no '{name}'. Objects have the numbers of the labels; actors and events of "
                        + "scenarios are known to harvester scenario run."
                );
            }

            if (change.Frame >= plan.Frames - 1)
            {
                throw new UsageException($"--change \"{change.Text}\": nothing follows frame {change.Frame} of {plan.Frames}.");
            }

            if (change.Id is not null && !plan.Options.Scenes)
            {
                throw new UsageException($"--change \"{change.Text}\" finds the object in the scenes; leave --no-scenes out.");
            }
        }
    }
}
