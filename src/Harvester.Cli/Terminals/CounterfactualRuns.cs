using Harvester.Exports.Pairs;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Terminals;

/// <summary>The same harvest several times: as it is, and once for each change.</summary>
internal sealed class CounterfactualRuns
{
    private readonly string[] _texts;
    private readonly IReadOnlyList<IReadOnlyList<TimedChange>> _changes;

    /// <summary>Reads the changes.</summary>
    /// <param name="texts">The changes of each run, as they are written on the command line.</param>
    /// <exception cref="UsageException">A text is not of their form, or there are too many.</exception>
    public CounterfactualRuns(string[] texts)
    {
        _texts = texts;
        _changes =
        [
            .. texts.Select(text =>
                ChangeText.Read(text) ?? throw new UsageException($"--change \"{text}\" is not of the form {ChangeText.Form}.")
            ),
        ];
        if (texts.Length > ChangeSet.MaxChanges)
        {
            throw new UsageException($"There may be at most {ChangeSet.MaxChanges} changes, not {texts.Length}.");
        }
    }

    /// <summary>All changes of all runs.</summary>
    public IEnumerable<TimedChange> Changes => _changes.SelectMany(run => run);

    /// <summary>Harvests the base and the changed runs, and describes them.</summary>
    /// <param name="terminal">Receives the messages.</param>
    /// <param name="plan">The harvest; its folder is that of the set.</param>
    /// <param name="command">The command as text, by which an unfinished set is known again.</param>
    /// <param name="withReport">Whether each session has a report.</param>
    /// <param name="cancellation">Stops after the current frame.</param>
    /// <exception cref="UsageException">The base has not what a change names.</exception>
    public int Harvest(Terminal terminal, HarvestPlan plan, string command, bool withReport, CancellationToken cancellation)
    {
        using var output = new RunsOutput(plan.Folder, command, ChangeSet.FileName);
        output.Begin();
        string original = Path.Combine(plan.Folder, ChangeSet.Base);
        plan = plan with { Resume = output.Continues };
        int code = HarvestRun.Of(terminal, plan with { Folder = original }, command, withReport, cancellation);
        List<ChangedRun> runs = [];
        for (int i = 0; i < _changes.Count && code == ExitCode.Done; i++)
        {
            string name = ChangeSet.FolderOf(i + 1);
            HarvestPlan changed = plan with
            {
                Folder = Path.Combine(plan.Folder, name),
                Changes = ChangedActors.Resolve(_changes[i], original),
            };
            runs.Add(new ChangedRun(name, _texts[i]));
            code = HarvestRun.Of(terminal, changed, command, withReport, cancellation);
        }

        if (code == ExitCode.Done)
        {
            output.Complete(_ => new ChangeSet(runs).Write(plan.Folder));
            terminal.Out.WriteLine($"{plan.Folder}: the base and {Counted.Of(runs.Count, "changed run")}");
        }

        return code;
    }
}
