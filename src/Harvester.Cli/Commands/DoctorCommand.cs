using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Diagnosis;
using Harvester.Runs.Faults;
using Harvester.Sessions.SelfTests;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester doctor: names the likely cause of a problem with the mod.</summary>
internal sealed class DoctorCommand
{
    private const string Notes =
        "LOG is GtaDataHarvester.log, ScriptHookVDotNet.log or ScriptHookV.log, or a renamed copy, or the zip or selftest.json of\n"
        + "the mod's self-test, which is explained line by line. FOLDER is a session, the game's folder or its scripts folder; all logs\n"
        + "in the folder are read together. Only the last run in the mod's log is read, unless --all-runs is given.\n"
        + "The likeliest cause comes first. The exit code is 1 if a problem was found.\n\n"
        + "Examples:\n"
        + "  harvester doctor \"C:\\Games\\Grand Theft Auto V\"\n"
        + "  harvester doctor GtaDataHarvester.log --all-runs\n"
        + "  harvester doctor selftest-20260101-120000.zip";

    private Argument<string> Place { get; } =
        new("LOG|FOLDER") { Description = "A log, the folder of the game or its scripts folder, a session, or a self-test" };
    private Option<bool> AllRuns { get; } = new("--all-runs") { Description = "Read all runs in the mod's log, not only the last one" };

    public static Command Create(Terminal terminal) => new DoctorCommand().Build(terminal);

    private ResultCommand Build(Terminal terminal)
    {
        var command = new ResultCommand(
            "doctor",
            "Read the logs of the mod, a session or a self-test, and name the likely cause of a problem."
        )
        {
            Place,
            AllRuns,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(Place), parsed.GetValue(AllRuns))));
        return command;
    }

    private static void Explain(Terminal terminal, SelfTestFile test)
    {
        terminal.Out.WriteLine(MessageLine.Of($"Self-test of {test.Tool} in {test.Game}"));
        foreach (SelfTestLine line in test.Lines)
        {
            terminal.Out.WriteLine(MessageLine.Of($"{JsonName.Of(line.Verdict), -8} {line.Check, -17} {line.Sentence}"));
            if (line.Verdict == SelfTestVerdict.Note)
            {
                terminal.Out.WriteLine($"{string.Empty, 26} {Diagnosis.AdviceFor(line.Check)}");
            }
        }

        foreach (string change in test.Changes)
        {
            terminal.Out.WriteLine(MessageLine.Of($"changed  {change}"));
        }
    }

    private static int Run(Terminal terminal, string place, bool allRuns)
    {
        Diagnosis diagnosis = Doctor.Examine(place, allRuns);
        foreach (LogFile log in diagnosis.Logs)
        {
            string leftAside = log.RunsLeftAside > 0 ? $", {Counted.Of(log.RunsLeftAside, "earlier run")} skipped" : string.Empty;
            terminal.Out.WriteLine($"Read {log.Path}: {Counted.Of(log.Runs.Sum(run => run.Count), "line")}{leftAside}");
        }

        if (diagnosis.SelfTest is { } test)
        {
            Explain(terminal, test);
        }

        int number = 0;
        foreach (Finding finding in diagnosis.Findings)
        {
            string count = finding.Count > 1 ? $" ({finding.Count} times)" : string.Empty;
            terminal.Out.WriteLine($"\n{++number}. {MessageLine.Of(finding.Cause)}{count}");
            terminal.Out.WriteLine($"   What to do: {finding.Advice}");
            if (finding.Evidence is { } evidence)
            {
                terminal.Out.WriteLine($"   Seen in {MessageLine.Of(evidence.ToString())}");
            }
        }

        terminal.Out.WriteLine(number == 0 ? $"No problem found in {place}" : $"\n{Counted.Of(number, "problem")} found in {place}");
        return number == 0 ? ExitCode.Done : ExitCode.BadData;
    }
}
