using System.CommandLine;
using System.Runtime.ExceptionServices;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Clients;
using Harvester.Runs.Driving;
using Harvester.Runs.Evaluation.Reports;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>
/// harvester drive: a controller drives by the lane indicators, and the drive is evaluated against the true state of the simulation.
/// </summary>
internal sealed class DriveCommand
{
    private const string Notes =
        "The indicators are undefined in junctions and show neither traffic lights nor right of way. In junctions, the car's built-in\n"
        + "driver follows the route; it hands over to the controller in the next lane. docs/driving.md describes the evaluation.\n\n"
        + "Examples:\n"
        + "  harvester drive --out drive\n"
        + "  harvester drive --controller deepdriving --noise --distance 3000 --out drive\n"
        + "  harvester drive --bridge socket --role game --out drive    # in one terminal\n"
        + "  harvester drive --bridge socket --role client              # in another\n"
        + "  harvester drive --roads data/example-roads.csv --near=-250,0 --near=250,0 --out drive\n"
        + "  harvester drive --seeds 701-720 --jobs 2 --distance 2000 --out drive\n"
        + "  harvester drive --roads data/example-roads.csv --places 20 --duration 900 --out drive";

    private Option<string?> Out { get; } = new("--out") { Description = "Folder to write drive.json and report.html to", HelpName = "DIR" };
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing drive in the folder" };
    private DriveOptions Drive { get; } = new();
    private RecordOptions Record { get; } = new("the drive as a session in this folder; one for each start if there are several");
    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new DrivingOptions().Picture);

    private DriveBridgeOptions Bridge { get; } = new();

    public static Command Create(Terminal terminal) => new DriveCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("drive", "Drive the simulated car by the lane indicators and evaluate the drive.") { Out, Overwrite };
        Drive.AddTo(command);
        foreach (Option option in Record.All.Append(Size).Concat(Bridge.All))
        {
            command.Options.Add(option);
        }

        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfDrive);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string? folder = parsed.GetValue(Out);
        BridgePlan bridge = Bridge.Parse(parsed, folder);
        DriveSettings plan = Drive.Parse(parsed) with { Bridge = bridge.Kind == BridgeName.Direct ? null : bridge };
        RecordPlan? recorded = Record.Parse(
            parsed,
            parsed.GetValue(Size),
            plan.Episodes.Count > 1,
            [.. Drive.RecordedSettings(parsed, plan)]
        );
        CheckRecording(parsed, plan, bridge, recorded);
        plan = plan with { PictureSize = recorded?.Size };
        if (bridge.Role == DriveRole.Client)
        {
            return RunClient(terminal, plan, bridge, cancellation);
        }

        if (folder is null)
        {
            throw new UsageException("Option '--out' is required.");
        }

        using FolderLock held = FolderLock.Take(folder);

        // The recording is finished after the drive.
        string recordingCommand = CommandText.WithOutput(parsed, folder);
        DriveMark? noted = recorded is null ? null : new DriveMark(recorded.Folder, recordingCommand, folder);
        bool isRepeated = noted?.IsThere() ?? false;
        using DriveRecording? recording = recorded is null
            ? null
            : new DriveRecording(terminal.WriteError, recorded, recordingCommand, parsed.GetValue(Overwrite));
        var output = new DriveFolder(folder, CommandText.Of(parsed), parsed.GetValue(Overwrite), isRepeated);
        int metres = (int)Math.Ceiling(plan.Metres * plan.Episodes.Count);
        var drives = new EpisodeRunner(plan, terminal.Out) { Recording = recording };
        ExceptionDispatchInfo? fault = new JobProgress(terminal, metres, "m").Run(report => FaultOf(drives, report, cancellation));
        ExceptionDispatchInfo? unrecorded = recording is null ? null : FaultOf(recording);

        // A drive whose recording has failed replaces no former one.
        fault ??= unrecorded;
        if (output.Replaces && unrecorded is not null)
        {
            fault!.Throw();
        }

        DriveRecord record = DriveRecord.Of(
            Drive.Settings(parsed, plan),
            drives.Episodes,
            isWhole: fault is null && !cancellation.IsCancellationRequested
        );
        string? former = Write(output, record, noted, unrecorded);
        if (former is not null)
        {
            terminal.WriteError($"The former drive is replaced, but its files in '{former}' cannot be deleted. Delete them yourself.");
        }

        foreach ((string name, string value) in record.Figures.Rows().Concat(record.Summary.Rows()))
        {
            terminal.Out.WriteLine($"{name + ":", -27}{value}");
        }

        if (!record.IsWhole)
        {
            terminal.Out.WriteLine(FormattableString.Invariant($"Stopped after {record.Figures.Metres:0} of {metres} m."));
        }

        if (fault is null)
        {
            // Otherwise the mark stays, so that the command can be given again.
            if (recording is not null)
            {
                terminal.Out.WriteLine(recording.Finish());
            }
        }

        terminal.Out.WriteLine($"report  {Path.Combine(folder, DriveReport.FileName)}");
        fault?.Throw();
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>Drives; returns the fault that ended the drive early, or null. A drive without samples throws it.</summary>
    private static ExceptionDispatchInfo? FaultOf(EpisodeRunner drives, Action<int> report, CancellationToken cancellation)
    {
        try
        {
            drives.Run(report, cancellation);
            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or GameFaultException)
        {
            // Not in the filter: it would run before the finally block that adds the samples.
            if (drives.Episodes.Count == 0)
            {
                throw;
            }

            return ExceptionDispatchInfo.Capture(e);
        }
    }

    /// <summary>Finishes a recording; returns the fault that ended it early, or null.</summary>
    private static ExceptionDispatchInfo? FaultOf(DriveRecording recording)
    {
        try
        {
            recording.Close();
            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return ExceptionDispatchInfo.Capture(e);
        }
    }

    /// <summary>Writes a drive. If that fails after its recording has, the fault of the recording is thrown.</summary>
    /// <returns>Where the former drive still is, if it could not be deleted; otherwise null.</returns>
    private static string? Write(DriveFolder output, DriveRecord record, DriveMark? noted, ExceptionDispatchInfo? unrecorded)
    {
        using var json = new MemoryStream();
        record.Write(json);
        byte[] bytes = json.ToArray();
        noted?.Note(bytes);
        try
        {
            return output.Write(folder =>
            {
                AtomicFile.Write(Path.Combine(folder, DriveRecord.FileName), stream => stream.Write(bytes));
                AtomicFile.Write(Path.Combine(folder, DriveReport.FileName), stream => DriveReport.Write(stream, record));
            });
        }
        catch (Exception e) when (unrecorded is not null && e is IOException or UnauthorizedAccessException)
        {
            unrecorded?.Throw();
            throw;
        }
    }

    private static int RunClient(Terminal terminal, DriveSettings plan, BridgePlan bridge, CancellationToken cancellation)
    {
        ClientDriver driver = new BridgeSetup(bridge, terminal.Out).RunClient(
            () => new EpisodeRunner(plan, terminal.Out).ControllerOf(plan.Seed),
            plan.Seconds,
            cancellation
        );
        string ending = driver.IsEndedByGame ? "; the game has closed the bridge" : "";
        string answered = Counted.Of(driver.Frames, "frame");
        terminal.Out.WriteLine(
            FormattableString.Invariant($"{answered} answered, {driver.Metres:0} m driven in {driver.Seconds:0} s{ending}")
        );
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    private void CheckRecording(ParseResult parsed, DriveSettings plan, BridgePlan bridge, RecordPlan? record)
    {
        if (record is null && parsed.GetResult(Size) is { Implicit: false })
        {
            throw new UsageException("--size needs --record.");
        }

        if (record is not null && bridge.Role == DriveRole.Client)
        {
            throw new UsageException("--record belongs to the side of the game, not to --role client.");
        }

        if (plan.IsDisturbed && plan.Bridge is not null)
        {
            throw new UsageException("--perturb needs a drive without a bridge.");
        }

        if (bridge.Role != DriveRole.Client)
        {
            CheckFolders(parsed.GetValue(Out), record?.Folder, bridge);
        }

        ImageSize sent = new DrivingOptions().Picture;
        if (record is not null && plan.Bridge is not null && record.Size.Width * sent.Height != record.Size.Height * sent.Width)
        {
            throw new UsageException("--size with --bridge must have the shape of the images on the bridge, 4 to 3.");
        }
    }

    /// <summary>Checks that each folder has a place of its own. Only the shared folder has one in that of the drive.</summary>
    private static void CheckFolders(string? output, string? recorded, BridgePlan bridge)
    {
        string? shared = bridge.Kind == BridgeName.Folder ? bridge.Folder : null;
        SeparateFolders.Check(("--record", recorded), ("--out", output));
        SeparateFolders.Check(("--record", recorded), ("--folder", shared));
        if (shared is not null && output is not null && !BridgeFolder.IsDefaultIn(output, shared))
        {
            SeparateFolders.Check(("--folder", shared), ("--out", output));
        }
    }

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
