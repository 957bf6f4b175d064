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
using Harvester.Driving.Session;
using Harvester.Evaluation.Clients;
using Harvester.Evaluation.Noise;
using Harvester.Evaluation.Reports;
using Harvester.Evaluation.Scores;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
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
        + "  harvester drive --roads nodes.zip --near=-500,1000 --near=0,2700 --out drive\n"
        + "  harvester drive --seeds 701-720 --jobs 2 --distance 2000 --out drive\n"
        + "  harvester drive --roads nodes.zip --places 20 --duration 900 --out drive";

    private Option<string?> Out { get; } =
        new("--out") { Description = "Folder to write drive.json and report.html to", HelpName = "DIR" };
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing drive in the folder" };
    private ControllerOptions Controller { get; } = new("Controller that drives", "stanley");

    private Option<int> Seed { get; } = WithDefault(
        ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);

    private Option<SeedRange?> Seeds { get; } = ValueParsers.Optional<SeedRange>(
        "--seeds",
        "A-B",
        "Drive with each of these seeds instead of one, from each start: a town and traffic for each",
        SeedRange.Parse,
        "two seeds, the smaller one first, at most 1000 in all, e.g. 701-720");

    private Option<FileInfo?> Roads { get; } = new("--roads")
    {
        Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
        HelpName = "FILE",
    };

    private Option<string[]> Near { get; } = new("--near")
    {
        Description = "Start position, metres; repeatable, for several drives in a row [default: the middle of the road network]",
        HelpName = "X,Y",
        DefaultValueFactory = _ => [],
    };

    private Option<int?> Places { get; } = ValueParsers.Optional<int>(
        "--places",
        "N",
        "Start at N places drawn from the seed, uniformly along the roads of --roads, instead of --near",
        text => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int n) && n is > 0 and <= 1000 ? n : null,
        "a whole number from 1 to 1000");

    private Option<int> Jobs { get; } = WithDefault(
        ValueParsers.Integer("--jobs", "N", "Number of drives at the same time; changes nothing in the result", 1, 256), 1);

    private Option<double> Distance { get; } = WithDefault(
        Positive("--distance", "M", "Distance to drive from each start, metres"), 1000);
    private Option<double> Duration { get; } = WithDefault(
        Positive("--duration", "S", "Time limit for each start, seconds of game time"), 3600);

    private Option<double> Traffic { get; } = WithDefault(
        ValueParsers.Number("--traffic", "F", "Factor on the number of vehicles", value => value is >= 0 and <= 4, "a number from 0 to 4"),
            1);

    private Option<double?> Speed { get; } = ValueParsers.Optional<double>(
        "--speed",
        "M/S",
        "Speed on a free straight road, metres per second [default: stanley 14, deepdriving 20]",
        text => ValueParsers.Number(text) is { } value && value is > 0 and <= 40 ? value : null,
        "a number greater than 0 and at most 40");

    private Option<bool> Noise { get; } = new("--noise")
    {
        Description = "Add noise to the indicators: the errors published for DeepDriving's network (0.03 rad, 0.2 m, and 3 m on distances "
            + "to vehicles)",
    };

    private Option<double> LookAhead { get; } = WithDefault(
        ValueParsers.Number("--look-ahead", "M", "Look-ahead distance for the angle, metres", value =>
            value is > 0 and <= 40, "a number greater than 0 and at most 40"),
        new ControllerPlan { Kind = ControllerKind.Stanley }.LookAheadMetres);

    private MomentOptions Moment { get; } = new();
    private RecordOptions Record { get; } = new("the drive as a session in this folder; one for each start if there are several");
    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new DrivingOptions().Picture);

    private Option<bool> Perturb { get; } = new("--perturb")
    {
        Description = "Push the steering aside now and then, seeded; recorded is what the controller answers, without the push",
    };

    private DriveBridgeOptions Bridge { get; } = new();

    public static Command Create(Terminal terminal) => new DriveCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("drive", "Drive the simulated car by the lane indicators and evaluate the drive.")
        {
            Out, Overwrite, Seed, Seeds, Roads, Near, Places, Jobs, Distance, Duration, Traffic, Speed, Noise, LookAhead, Size, Perturb,
        };
        Moment.AddTo(command);
        foreach (Option option in Controller.All.Concat(Record.All).Concat(Bridge.All))
        {
            command.Options.Add(option);
        }

        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string? folder = parsed.GetValue(Out);
        BridgePlan bridge = Bridge.Parse(parsed, folder);
        DrivePlan plan = PlanOf(parsed) with { Bridge = bridge.Kind == BridgeName.Direct ? null : bridge };
        RecordPlan? recorded = Record.Parse(parsed, parsed.GetValue(Size), plan.Episodes.Count > 1, [.. RecordedSettings(parsed, plan)]);
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
        var output = new DriveFolder(folder, CommandText.Of(parsed), parsed.GetValue(Overwrite));
        int metres = (int)Math.Ceiling(plan.Metres * plan.Episodes.Count);
        using DriveRecording? recording = recorded is null ? null
            : new DriveRecording(terminal, recorded, CommandText.Of(parsed), parsed.GetValue(Overwrite));
        var drives = new SimulatedDrives(plan, terminal.Out) { Recording = recording };
        ExceptionDispatchInfo? fault = new JobProgress(terminal, metres, "m").Run(report => FaultOf(drives, report, cancellation));
        DriveRecord record = DriveRecord.Of(
            SettingsOf(parsed, plan), drives.Episodes, isWhole: fault is null && !cancellation.IsCancellationRequested);
        string? former = output.Write(written =>
        {
            AtomicFile.Write(Path.Combine(written, DriveRecord.FileName), record.Write);
            AtomicFile.Write(Path.Combine(written, DriveReport.FileName), stream => DriveReport.Write(stream, record));
        });
        if (former is not null)
        {
            terminal.WriteError($"The former drive is replaced, but its files in '{former}' cannot be deleted. Delete them yourself.");
        }

        foreach ((string name, string value) in record.Figures.Rows().Concat(record.Summary.Rows()))
        {
            terminal.Out.WriteLine($"{name + ":",-27}{value}");
        }

        if (!record.IsWhole)
        {
            terminal.Out.WriteLine(FormattableString.Invariant($"Stopped after {record.Figures.Metres:0} of {metres} m."));
        }

        recording?.Finish();
        terminal.Out.WriteLine($"report  {Path.Combine(folder, DriveReport.FileName)}");
        fault?.Throw();
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>Drives; returns the fault that ended the drive early, or null. A drive without samples throws it.</summary>
    private static ExceptionDispatchInfo? FaultOf(SimulatedDrives drives, Action<int> report, CancellationToken cancellation)
    {
        try
        {
            drives.Run(report, cancellation);
            return null;
        }
        catch (Exception e) when (e is IOException or GameFaultException)
        {
            // Not in the filter: it would run before the finally block that adds the samples.
            if (drives.Episodes.Count == 0)
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
        string answered = Counted.Of(driver.Frames, "frame");
        terminal.Out.WriteLine(
            FormattableString.Invariant($"{answered} answered, {driver.Metres:0} m driven in {driver.Seconds:0} s{ending}"));
        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    private void CheckStarts(ParseResult parsed)
    {
        if (IsGiven(Seeds) && IsGiven(Seed))
        {
            throw new UsageException("--seeds and --seed exclude each other.");
        }

        if (IsGiven(Places) && (!IsGiven(Roads) || IsGiven(Near) || IsGiven(Seeds)))
        {
            throw new UsageException("--places takes --roads, and excludes --near and --seeds.");
        }

        bool IsGiven(Option option) => parsed.GetResult(option) is { Implicit: false };
    }

    private DrivePlan PlanOf(ParseResult parsed)
    {
        CheckStarts(parsed);
        RoadNetwork? roads = parsed.GetValue(Roads) is { } file ? RoadImporter.Import(file.FullName).Network : null;
        int seed = parsed.GetValue(Seed);
        return new DrivePlan
        {
            Controller = Controller.Parse(parsed) with { Speed = parsed.GetValue(Speed), LookAheadMetres = parsed.GetValue(LookAhead) },
            Seed = seed,
            Seeds = parsed.GetValue(Seeds) is { } seeds ? [.. seeds.All] : [],
            Roads = roads,
            Starts = parsed.GetValue(Places) is { } places
                ? RandomPlaces.On(roads!, places, seed)
                : [.. parsed.GetRequiredValue(Near).Select(ParsePlace)],
            Jobs = parsed.GetValue(Jobs),
            TrafficDensity = parsed.GetValue(Traffic),
            Metres = parsed.GetValue(Distance),
            Seconds = parsed.GetValue(Duration),
            Noise = parsed.GetValue(Noise) ? NoiseLevels.Published : null,
            IsDisturbed = parsed.GetValue(Perturb),
            Weather = Moment.Weather(parsed),
            TimeOfDay = Moment.TimeOfDay(parsed),
            DayOfYear = Moment.DayOfYear(parsed),
        };
    }

    private Dictionary<string, string> SettingsOf(ParseResult parsed, DrivePlan plan)
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

        if (parsed.GetValue(Seeds) is { } seeds)
        {
            settings["seed"] = seeds.ToString();
        }

        if (plan.Starts.Count > 0)
        {
            settings["near"] = string.Join(' ', plan.Starts.Select(start => FormattableString.Invariant($"{start.X},{start.Y}")));
        }

        return settings;
    }

    private void CheckRecording(ParseResult parsed, DrivePlan plan, BridgePlan bridge, RecordPlan? record)
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

        if (record is not null && parsed.GetValue(Out) is { } folder && Path.GetFullPath(folder) == Path.GetFullPath(record.Folder))
        {
            throw new UsageException("--record and --out name the same folder; give the session one of its own.");
        }

        ImageSize sent = new DrivingOptions().Picture;
        if (record is not null && plan.Bridge is not null && record.Size.Width * sent.Height != record.Size.Height * sent.Width)
        {
            throw new UsageException("--size with --bridge must have the shape of the images on the bridge, 4 to 3.");
        }
    }

    private IEnumerable<KeyValuePair<string, string>> RecordedSettings(ParseResult parsed, DrivePlan plan)
    {
        yield return new("weather", plan.Weather);
        yield return new("dayOfYear", plan.DayOfYear.ToString(CultureInfo.InvariantCulture));
        yield return new("timeOfDay", plan.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        foreach (KeyValuePair<string, string> setting in SettingsOf(parsed, plan).Where(setting => setting.Key != "seed"))
        {
            yield return setting;
        }

        yield return new("perturb", plan.IsDisturbed ? "on" : "off");
    }

    private static Vector2D ParsePlace(string text) => ValueParsers.Numbers(text, 2) is { } n
        ? new Vector2D(n[0], n[1])
        : throw new UsageException($"--near takes two numbers, e.g. 0,-1000, not '{text}'.");

    private static Option<double> Positive(string name, string form, string description) =>
        ValueParsers.Number(name, form, description, value => value is > 0 and <= 1_000_000, "a number greater than 0 and at most 1000000");

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
