using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Driving;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads;
using Harvester.Driving.Controllers;
using Harvester.Evaluation.Clients;
using Harvester.Evaluation.Figures;
using Harvester.Evaluation.Noise;
using Harvester.Evaluation.Reports;
using Harvester.Geometry;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Commands;

/// <summary>
/// harvester drive: a controller drives by the lane indicators and is evaluated against the true state of the simulation.
/// </summary>
internal static class DriveCommand
{
    private const string Notes =
        "The indicators are undefined in junctions and show neither traffic lights nor right of way. In junctions the car's built-in driver\n"
        + "follows the route, and hands over to the controller in the next lane. docs/driving.md describes the evaluation.\n\n"
        + "Examples:\n"
        + "  harvester drive --out drive\n"
        + "  harvester drive --controller deepdriving --noise --distance 3000 --out drive\n"
        + "  harvester drive --bridge socket --role game --out drive        and elsewhere: harvester drive --bridge socket --role client\n"
        + "  harvester drive --roads nodes.zip --near=-500,1000 --near=0,2700 --out drive";

    private static readonly Option<string?> Out =
        new("--out") { Description = "Folder to write drive.json and report.html to", HelpName = "DIR" };
    private static readonly Option<bool> Overwrite = new("--overwrite") { Description = "Replace an existing drive in the folder" };
    private static readonly ControllerOptions Controller = new("The controller that drives", "stanley");

    private static readonly Option<int> Seed = WithDefault(
        ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);

    private static readonly Option<FileInfo?> Roads = new("--roads")
    {
        Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
        HelpName = "FILE",
    };

    private static readonly Option<string[]> Near = new("--near")
    {
        Description = "Start position, metres; repeatable, for several drives in a row [default: the middle of the road network]",
        HelpName = "X,Y",
        DefaultValueFactory = _ => [],
    };

    private static readonly Option<double> Distance = WithDefault(
        Positive("--distance", "M", "Distance to drive from each start, metres"), 1000);
    private static readonly Option<double> Duration = WithDefault(
        Positive("--duration", "S", "Time limit for each start, seconds of game time"), 3600);

    private static readonly Option<double> Traffic = WithDefault(
        ValueParsers.Number("--traffic", "F", "Factor on the number of vehicles", value => value is >= 0 and <= 4, "a number from 0 to 4"),
            1);

    private static readonly Option<double?> Speed = ValueParsers.Optional<double>(
        "--speed",
        "M/S",
        "Speed on a free straight road, metres per second [default: stanley 14, deepdriving 20]",
        text => ValueParsers.Number(text) is { } value && value is > 0 and <= 40 ? value : null,
        "a number greater than 0 and at most 40");

    private static readonly Option<bool> Noise = new("--noise")
    {
        Description = "Add the errors published for DeepDriving's network to the indicators: 0.03 rad, 0.2 m, and 3 m on distances to vehicles",
    };

    private static readonly Option<double> LookAhead = WithDefault(
        ValueParsers.Number("--look-ahead", "M", "Look-ahead distance for the angle, metres", value =>
            value is > 0 and <= 40, "a number greater than 0 and at most 40"),
        new ControllerPlan { Kind = ControllerKind.Stanley }.LookAheadMetres);

    public static Command Create(Terminal terminal)
    {
        var command = new Command("drive", "Drive the simulated car by the lane indicators and evaluate the drive.")
        {
            Out, Overwrite, Seed, Roads, Near, Distance, Duration, Traffic, Speed, Noise, LookAhead,
        };
        foreach (Option option in Controller.All.Concat(DriveBridgeOptions.All))
        {
            command.Options.Add(option);
        }

        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private static int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string? folder = parsed.GetValue(Out);
        BridgePlan bridge = DriveBridgeOptions.Parse(parsed, folder);
        DrivePlan plan = PlanOf(parsed) with { Bridge = bridge.Kind == BridgeName.Direct ? null : bridge };
        if (bridge.Role == DriveRole.Client)
        {
            return RunClient(terminal, plan, bridge, cancellation);
        }

        if (folder is null)
        {
            throw new UsageException("Option '--out' is required.");
        }

        using FolderLock held = FolderLock.Take(folder);
        DriveFolder.Prepare(folder, parsed.GetValue(Overwrite));
        int metres = (int)Math.Ceiling(plan.Metres * Math.Max(1, plan.Starts.Count));
        var drives = new SimulatedDrives(plan, terminal.Out);
        ExceptionDispatchInfo? fault = new JobProgress(terminal, metres, "m").Run(report => FaultOf(drives, report, cancellation));
        DriveRecord record = DriveRecord.Of(
            SettingsOf(parsed, plan), drives.Samples, isWhole: fault is null && !cancellation.IsCancellationRequested);
        string report = Path.Combine(folder, DriveReport.FileName);
        AtomicFile.Write(Path.Combine(folder, DriveRecord.FileName), record.Write);
        AtomicFile.Write(report, stream => DriveReport.Write(stream, record, drives.Samples));
        foreach ((string name, string value) in record.Figures.Rows())
        {
            terminal.Out.WriteLine($"{name + ":",-19}{value}");
        }

        if (!record.IsWhole)
        {
            terminal.Out.WriteLine(FormattableString.Invariant($"Stopped after {record.Figures.Metres:0} of {metres} m."));
        }

        terminal.Out.WriteLine($"report  {report}");
        fault?.Throw();
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>Drives, and says what ended it before its time; a drive that came nowhere leaves nothing.</summary>
    private static ExceptionDispatchInfo? FaultOf(SimulatedDrives drives, Action<int> report, CancellationToken cancellation)
    {
        try
        {
            drives.Run(report, cancellation);
            return null;
        }
        catch (Exception e) when (e is IOException or GameFaultException)
        {
            // Not in the filter, which would run before the drive hands its samples over.
            if (drives.Samples.Count == 0)
            {
                throw;
            }

            return ExceptionDispatchInfo.Capture(e);
        }
    }

    private static int RunClient(Terminal terminal, DrivePlan plan, BridgePlan bridge, CancellationToken cancellation)
    {
        ClientDriver driver = new RemoteDrives(bridge, terminal.Out)
            .RunClient(() => new SimulatedDrives(plan, terminal.Out).ControllerOf(plan.Seed), plan.Seconds, cancellation);
        string ending = driver.IsEndedByGame ? "; the game has closed the bridge" : "";
        terminal.Out.WriteLine(FormattableString.Invariant($"{Counted.Of(driver.Frames, "frame")} answered, {driver.Metres:0} m driven in {driver.Seconds:0} s{ending}"));
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    private static DrivePlan PlanOf(ParseResult parsed)
    {
        return new DrivePlan
        {
            Controller = Controller.Parse(parsed) with { Speed = parsed.GetValue(Speed), LookAheadMetres = parsed.GetValue(LookAhead) },
            Seed = parsed.GetValue(Seed),
            Roads = parsed.GetValue(Roads) is { } roads ? RoadImporter.Import(roads.FullName).Network : null,
            Starts = [.. parsed.GetRequiredValue(Near).Select(ParsePlace)],
            TrafficDensity = parsed.GetValue(Traffic),
            Metres = parsed.GetValue(Distance),
            Seconds = parsed.GetValue(Duration),
            Noise = parsed.GetValue(Noise) ? NoiseLevels.Published : null,
        };
    }

    private static Dictionary<string, string> SettingsOf(ParseResult parsed, DrivePlan plan)
    {
        Dictionary<string, string> settings = new(StringComparer.Ordinal)
        {
            ["controller"] = plan.Controller.Kind == ControllerKind.Stanley ? "stanley" : "deepdriving",
            ["emergencyBrake"] = plan.Controller.BrakesInEmergency ? "on" : "off",
            ["seed"] = plan.Seed.ToString(CultureInfo.InvariantCulture),
            ["bridge"] = plan.Bridge is { } bridge ? (bridge.Kind == BridgeName.Folder ? "folder" : "socket") : "direct",
            ["roads"] = parsed.GetValue(Roads)?.Name ?? "town",
            ["distanceMetres"] = plan.Metres.ToString(CultureInfo.InvariantCulture),
            ["durationSeconds"] = plan.Seconds.ToString(CultureInfo.InvariantCulture),
            ["traffic"] = plan.TrafficDensity.ToString(CultureInfo.InvariantCulture),
            ["lookAheadMetres"] = plan.Controller.LookAheadMetres.ToString(CultureInfo.InvariantCulture),
            ["noise"] = plan.Noise is { } noise
                ? FormattableString.Invariant($"{noise.AngleRadians} rad, {noise.MarkingMetres} m, {noise.VehicleMetres} m")
                : "none",
        };
        if (plan.Controller.Speed is { } speed)
        {
            settings["speed"] = speed.ToString(CultureInfo.InvariantCulture);
        }

        if (plan.Starts.Count > 0)
        {
            settings["near"] = string.Join(' ', plan.Starts.Select(start => FormattableString.Invariant($"{start.X},{start.Y}")));
        }

        return settings;
    }

    private static Vector2D ParsePlace(string text) => ValueParsers.Numbers(text, 2) is { } n
        ? new Vector2D(n[0], n[1])
        : throw new UsageException($"--near takes two numbers, not '{text}'.");

    private static Option<double> Positive(string name, string form, string description) =>
        ValueParsers.Number(name, form, description, value => value is > 0 and <= 1_000_000, "a number greater than 0 and at most 1000000");

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
