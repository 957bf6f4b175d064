using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>
/// Writing commands are killed at random moments and given again. A process runs several commands at once, each in several folders, again
/// and again, until SIGKILL ends it: one kill stops every command at several moments of its own. HARVESTER_STOPS sets how often each
/// command is stopped, HARVESTER_STOPS_SEED the seed. docs/reliability.md has the figures.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class KilledCommandTests : IDisposable
{
    private const int Stops = 60;
    private const int StopsInCi = 10;
    private const int DefaultSeed = 20260101;
    private const int Threads = 10;

    private const string NotBegun = "not begun";
    private const string Locked = "with nothing written but the lock";
    private const string HalfWritten = "half written";
    private const string Over = "over";

    /// <summary>Two processes at a time share the processors on which the time of all commands was measured for one.</summary>
    private const double LatestMoment = 2;

    /// <summary>A third of what the weakest of several runs had, on a machine busy with other work.</summary>
    private const double MinUnderWayFraction = 0.1;

    private static readonly string[] States = [NotBegun, Locked, HalfWritten, Over];

    private readonly ITestOutputHelper _output;
    private readonly TemporaryFolder _folder = new();
    private readonly Dictionary<string, CommandTrial> _trials;
    private readonly ConcurrentDictionary<(string Name, string State), int> _states = new();
    private readonly ConcurrentQueue<string> _faults = new();

    public KilledCommandTests(ITestOutputHelper output)
    {
        _output = output;
        CommandTrial.MakeInputs(Inputs);
        _trials = Commands.ToDictionary(
            command => command.Name,
            command => new CommandTrial(command, Inputs, Path.Combine(Trials, command.Name))
        );
    }

    private static IEnumerable<WritingCommand> Commands => WritingCommand.Chosen.Where(command => command.IsKilled);

    private string Inputs => _folder.PathOf("inputs");

    private string Trials => _folder.PathOf("trials");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Killed_command_given_again_ends_as_if_undisturbed()
    {
        int stops = TestSetting.Number("HARVESTER_STOPS", ProofSize.Of(StopsInCi, Stops));
        int seed = TestSetting.Number("HARVESTER_STOPS_SEED", DefaultSeed);
        FolderContent inputs = FolderContent.Of(Inputs);

        // Commands that take long would be slowed down by the others, which would run many times meanwhile.
        WritingCommand[][] groups = [.. Commands.GroupBy(command => command.BuildsWorld).Select(group => group.ToArray())];
        TimeSpan[] latest = [.. groups.Select(group => LatestMoment * TimeOfAll(group))];
        int kills = (stops + Threads - 1) / Threads;
        Parallel.For(
            0,
            kills * groups.Length,
            new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            kill =>
            {
                int group = kill % groups.Length;
                KillAndRepeat(groups[group], latest[group] * new Random(unchecked((seed * 31) + kill)).NextDouble());
            }
        );

        string moments = string.Join(
            ", ",
            latest.Select(time => string.Create(CultureInfo.InvariantCulture, $"{time.TotalSeconds:0.0} s"))
        );
        _output.WriteLine($"seed {seed}, {kills} kills of each of {groups.Length} groups of commands, at moments up to {moments}");
        foreach (string name in _trials.Keys)
        {
            _output.WriteLine($"{name}: " + string.Join(", ", States.Select(state => $"{Of(name, state)} {state}")));
        }

        Assert.True(_faults.IsEmpty, $"{_faults.Count} of {kills * Threads * _trials.Count}:\n{string.Join('\n', _faults.Take(20))}");
        Assert.Equal(inputs, FolderContent.Of(Inputs));

        // Kills before and after the commands would prove nothing. Those that write one file at their end are rarely hit.
        int underWay = _trials.Keys.Sum(name => Of(name, Locked) + Of(name, HalfWritten));
        Assert.True(underWay >= MinUnderWayFraction * kills * Threads * _trials.Count, $"Only {underWay} stops found a command under way.");
    }

    private int Of(string name, string state) => _states.GetValueOrDefault((name, state));

    /// <summary>How long a process takes until every command has ended once.</summary>
    private TimeSpan TimeOfAll(WritingCommand[] commands)
    {
        string work = _folder.PathOf("measured");
        using Process process = Start(commands, work);
        var time = Stopwatch.StartNew();
        AssertLine(CommandLoop.AllDone, process);
        time.Stop();
        Kill(process);
        Directory.Delete(work, recursive: true);
        return time.Elapsed;
    }

    private void KillAndRepeat(WritingCommand[] commands, TimeSpan moment)
    {
        string work = _folder.PathOf(Guid.NewGuid().ToString("N"));
        using (Process process = Start(commands, work))
        {
            Thread.Sleep(moment);
            Kill(process);
        }

        foreach (CommandTrial trial in commands.Select(command => _trials[command.Name]))
        {
            for (int thread = 0; thread < Threads; thread++)
            {
                Repeat(trial, Path.Combine(CommandLoop.FolderOf(work, trial.Command, thread), CommandLoop.Root));
            }
        }

        Directory.Delete(work, recursive: true);
    }

    private void Repeat(CommandTrial trial, string root)
    {
        string name = trial.Command.Name;
        string state = StateOf(trial, root);
        _states.AddOrUpdate((name, state), 1, static (_, count) => count + 1);
        if (!Directory.Exists(root))
        {
            return;
        }

        // The folders are exchanged in one step on Linux.
        FolderContent left = CommandTrial.ResultIn(root);
        if (trial.Command.Replaces && OperatingSystem.IsLinux() && !trial.IsWhole(left))
        {
            _faults.Enqueue($"{name}: neither the old nor the new is whole: {left.DifferenceFrom(trial.Expected)}");
        }

        if (trial.FaultOfRepetition(root, left) is { } fault)
        {
            _faults.Enqueue($"{name}, {state}: {fault}");
        }
    }

    private static string StateOf(CommandTrial trial, string root)
    {
        FolderContent all = CommandTrial.ContentOf(root);
        return !Directory.Exists(root) || all.Equals(trial.Former) ? NotBegun
            : all.Equals(trial.Expected) ? Over
            : all.Without(static name => name.Contains(".harvester-lock", StringComparison.Ordinal)).Equals(trial.Former) ? Locked
            : HalfWritten;
    }

    private Process Start(WritingCommand[] commands, string work)
    {
        string[] arguments =
        [
            typeof(Program).Assembly.Location,
            "loop",
            Inputs,
            Trials,
            work,
            $"{Threads}",
            .. commands.Select(command => command.Name),
        ];
        var start = new ProcessStartInfo("dotnet", arguments) { RedirectStandardInput = true, RedirectStandardOutput = true };

        // It lives for seconds only: compiling everything at once, as the tests do, would take most of them, and so would drawing by code
        // that is not optimized.
        start.Environment["DOTNET_TieredCompilation"] = "1";
        start.Environment["DOTNET_TC_QuickJitForLoops"] = "0";
        Process process = Process.Start(start)!;
        AssertLine(CommandLoop.Begun, process);
        return process;
    }

    private static void AssertLine(string line, Process process) => Assert.Equal(line, process.StandardOutput.ReadLine());

    private static void Kill(Process process)
    {
        Assert.False(process.HasExited, "It has ended by itself.");
        process.Kill();
        process.WaitForExit();
    }
}
