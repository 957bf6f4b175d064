using System.Diagnostics;
using System.Text.RegularExpressions;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>
/// Runs a command in this process once for each fault in one of its file operations, and again without a fault. A process of its own would
/// take most of the time to start.
/// </summary>
internal sealed partial class FaultDriver
{
    private static readonly int[] Errors = [Fault.DiskFull, Fault.InputOutput, Fault.PermissionDenied];

    private static readonly bool AreAllTried = Environment.GetEnvironmentVariable("HARVESTER_FAULTS") == "all";

    /// <summary>Of the operations that are not the first of their kind, CI tries every third.</summary>
    private static readonly int Stride = AreAllTried ? 1 : ProofSize.Of(inCi: 3, full: 1);

    /// <summary>
    /// Whether the first operation of each kind is tried with all errors, and others too; otherwise only the first of each kind, with one
    /// error or the kill, in turn. CI has no time for more than that of commands that are variants of others.
    /// </summary>
    private readonly bool _isThorough;

    /// <summary>How often the drive of a command vanishes, at equal distances over its operations.</summary>
    private const int Vanishings = 5;

    /// <summary>As <see cref="Vanishings"/>, of a command that is a variant of another.</summary>
    private const int VanishingsOfVariants = 2;

    private readonly CommandTrial _trial;
    private readonly string _root;
    private readonly IReadOnlyList<FileOperation> _operations;
    private readonly List<string> _failures = [];
    private int _faults;

    private FaultDriver(CommandTrial trial, string root)
    {
        _trial = trial;
        _root = root;
        _isThorough = trial.Command.IsBasic || AreAllTried;
        trial.Restore(root);
        FaultInjector.Begin(root, Fault.None);
        trial.Run(root);
        FaultInjector.End();
        _operations =
        [
            .. FaultInjector
                .Operations()
                .Where(operation => !WritingCommand.IsTimed(operation.Path))
                .Where(operation =>
                    trial.Command.Only is not { } only || only.Any(start => operation.Path.StartsWith(start, StringComparison.Ordinal))
                ),
        ];
    }

    /// <summary>Runs the commands whose names come from standard input, one a line, with all their faults.</summary>
    /// <remarks>The answer to each name is a line with the figures, the failures, indented, and an empty line.</remarks>
    /// <param name="library">The fault injector.</param>
    /// <param name="inputs">The inputs of the commands.</param>
    /// <param name="folder">An empty folder.</param>
    public static int Run(string library, string inputs, string folder)
    {
        FaultInjector.Attach(library);
        while (Console.ReadLine() is { } name)
        {
            var watch = Stopwatch.StartNew();
            string own = Path.Combine(folder, name);
            var trial = new CommandTrial(WritingCommand.All.Single(command => command.Name == name), inputs, own);
            var driver = new FaultDriver(trial, Path.Combine(own, "root"));
            driver.RunFaults();
            Console.WriteLine(
                $"{name}: {driver._operations.Count} operations, {driver._faults} faults, {driver._failures.Count} failures, "
                    + $"{watch.Elapsed.TotalSeconds:0} s"
            );
            driver._failures.Take(20).ToList().ForEach(Console.WriteLine);
            Console.WriteLine();
            Directory.Delete(own, recursive: true);
        }

        return 0;
    }

    /// <summary>
    /// Each operation fails with one error. The first of each kind on each kind of file fails with all errors: the frames after the first
    /// are written as the first, so that a command that is a variant of another is tried with the first only. Each operation also kills the
    /// command, once for every state of the disk: before an operation that comes after opening, flushing or closing an existing file, the
    /// disk is as it was before that.
    /// </summary>
    private void RunFaults()
    {
        var kinds = new HashSet<string>(StringComparer.Ordinal);
        foreach ((int index, FileOperation operation) in _operations.Index())
        {
            bool isNew = kinds.Add($"{operation.Kind} {Digits().Replace(operation.Path, "#")}");
            if (!isNew && (!_isThorough || index % Stride != 0))
            {
                continue;
            }

            bool kills = index == 0 || _trial.Command.Only is not null || _operations[index - 1].Kind is not ("open" or "flush" or "close");

            // Of a variant, every other operation fails, and the others kill.
            bool fails = _isThorough || !kills || kinds.Count % 2 == 1;
            int[] errors =
                !fails ? []
                : isNew && _isThorough ? Errors
                : [Errors[index / Stride % Errors.Length]];
            Array.ForEach(errors, error => Check(new Fault(operation, error)));
            if (kills && (_isThorough || !fails))
            {
                Check(new Fault(operation, Fault.InputOutput, Kills: true));
            }
        }

        // What it leaves on the disk is what a kill leaves there; here the command goes on and must report it.
        int vanishings = _isThorough ? Vanishings : VanishingsOfVariants;
        for (int i = 0; i < vanishings; i++)
        {
            Check(new Fault(_operations[i * (_operations.Count - 1) / (vanishings - 1)], Fault.InputOutput, Vanishes: true));
        }

        if (_operations.Any(operation => operation.Kind == "exchange"))
        {
            RunFaultsOfTwoRenames();
        }
    }

    private void RunFaultsOfTwoRenames()
    {
        _trial.Restore(_root);
        FaultInjector.Begin(_root, Fault.None with { CanExchange = false });
        _trial.Run(_root);
        FaultInjector.End();
        foreach (FileOperation operation in FaultInjector.Operations().Except(_operations).Where(operation => operation.Kind == "rename"))
        {
            Check(new Fault(operation, Fault.InputOutput, CanExchange: false));
            Check(new Fault(operation, Fault.InputOutput, Kills: true, CanExchange: false));
        }
    }

    private void Check(Fault fault)
    {
        _faults++;
        _trial.Restore(_root);
        FaultInjector.Begin(_root, fault);
        CliRun run = _trial.Run(_root);

        // Files that were left open would be written to at any time later.
        GC.Collect();
        GC.WaitForPendingFinalizers();
        bool hasFired = FaultInjector.End();
        FolderContent result = CommandTrial.ResultIn(_root);
        if (!hasFired)
        {
            Fail(fault, "the operation did not come");
        }

        if (!fault.Kills && run.ExitCode is not (ExitCode.Done or ExitCode.InputOutput))
        {
            Fail(fault, $"exit code {run.ExitCode}: {run.Error}");
        }

        if (!fault.Kills && run.ExitCode != ExitCode.Done && run.Error.Count(character => character == '\n') != 1)
        {
            Fail(fault, $"not one line: {run.Error}");
        }

        if (!fault.Kills && run.ExitCode == ExitCode.Done && !result.Equals(_trial.Expected))
        {
            Fail(fault, $"success with another result: {result.DifferenceFrom(_trial.Expected)}");
        }

        if (_trial.Command.Replaces && (fault.CanExchange || !fault.Kills) && !_trial.IsWhole(result))
        {
            Fail(fault, $"neither the old nor the new is whole: {result.DifferenceFrom(_trial.Expected)}");
        }

        if (_trial.FaultOfRepetition(_root, result) is { } wrong)
        {
            Fail(fault, wrong);
        }
    }

    [GeneratedRegex("[0-9]+")]
    private static partial Regex Digits();

    private void Fail(Fault fault, string what) => _failures.Add($"  {fault}: {what.TrimEnd()}");
}
