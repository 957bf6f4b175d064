using System.CommandLine;
using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Serving;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Commands;

/// <summary>harvester serve: serves the simulated game to a driving program over the live bridge.</summary>
internal sealed class ServeCommand
{
    private const string Notes =
        "docs/bridge.md describes the protocol; examples/ has two clients in Python. The game runs in real time; a client that requests\n"
        + "single steps gets them as fast as the machine allows. With --lockstep it moves only by these steps, and the same seed\n"
        + "and messages give the same frames; docs/gym.md describes a Gymnasium environment over it.\n\n"
        + "Examples:\n"
        + "  harvester serve\n"
        + "  harvester serve --seed 7 --traffic 0 --port 5000 --duration 600\n"
        + "  harvester serve --lockstep --unassisted --port 0\n"
        + "  harvester serve --folder shared --roads data/example-roads.csv --near=-250,0";

    private BridgeOptions Bridge { get; } = new();
    private Option<int> Seed { get; } = WithDefault(ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);
    private Option<FileInfo?> Roads { get; } =
        new("--roads")
        {
            Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
            HelpName = "FILE",
        };

    private Option<Vector2D?> Near { get; } =
        ValueParsers.Point(
            "--near",
            "X,Y",
            "Start position of the first game, metres; a restart takes its start from its seed [default: the middle of the road network]"
        );
    private Option<double> Traffic { get; } =
        WithDefault(
            ValueParsers.Number(
                "--traffic",
                "F",
                "Factor on the number of vehicles and pedestrians",
                value => value is >= 0 and <= 10,
                "a number from 0 to 10"
            ),
            1
        );

    private Option<double?> TrafficRadius { get; } =
        ValueParsers.Optional<double>(
            "--traffic-radius",
            "M",
            "Move vehicles and pedestrians only within this distance of the car, metres, to save time [default: all]",
            text => NumberText.Read(text) is >= 50 and <= 10_000 and var metres ? metres : null,
            "a number from 50 to 10000"
        );

    private Option<string> WeatherName { get; } =
        new("--weather")
        {
            Description = "Weather: " + string.Join(", ", WeatherNames.All),
            HelpName = "W",
            DefaultValueFactory = _ => "clear",
        };

    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new DrivingOptions().Picture);
    private Option<double> Hz { get; } =
        WithDefault(
            ValueParsers.Number(
                "--hz",
                "N",
                "Frames per second of game time",
                value => value is > 0 and <= SimulatedHarvest.TicksPerSecond,
                "a number greater than 0 and at most 60"
            ),
            10
        );

    private Option<double?> Duration { get; } =
        ValueParsers.Optional<double>(
            "--duration",
            "S",
            "Stop after this much game time, seconds [default: serve until Ctrl+C]",
            text => NumberText.Read(text) is > 0 and var seconds ? seconds : null,
            "a number greater than 0"
        );

    private ControllerOptions Controller { get; } = new("Controller that drives when the program sends indicators", "deepdriving");

    private Option<bool> Unassisted { get; } =
        new("--unassisted")
        {
            Description =
                "Let the program drive through junctions too, where the indicators are undefined [default: the built-in driver does]",
        };

    private Option<bool> LockStep { get; } =
        new("--lockstep")
        {
            Description = "Advance the world only by the steps that the program requests, and let it restart the game with other seeds",
        };

    private Option<bool> Once { get; } =
        new("--once") { Description = "Stop when the first program has disconnected, or if none connects within a minute" };

    private RecordOptions Record { get; } = new("the drive as a session in this folder; with --lockstep, one for each restart");
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing session in the folder of --record" };

    public static Command Create(Terminal terminal) => new ServeCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("serve", "Serve the simulated game to a driving program over the live bridge.");
        Bridge.AddTo(command);
        Option[] own = [Seed, Roads, Near, Traffic, TrafficRadius, WeatherName, Size, Hz, Duration, Unassisted, LockStep, Once];
        foreach (Option option in own.Concat(Controller.All).Concat(Record.All).Append(Overwrite))
        {
            command.Options.Add(option);
        }

        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfServe);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        SeparateFolders.Check(("--record", Record.FolderOf(parsed)), ("--folder", Bridge.FolderOf(parsed)));
        ControllerPlan controller = Controller.Parse(parsed) with { LookAheadMetres = 0 };
        SimulationOptions world = WorldOf(parsed);
        SimulationOptions current = world;
        SimulatedGame first = Build(world);
        bool isLockStep = parsed.GetValue(LockStep);
        var options = new DrivingOptions
        {
            Picture = parsed.GetValue(Size),
            RateHz = parsed.GetValue(Hz),
            IsLockStep = isLockStep,
        };
        RecordPlan? plan = Record.Parse(parsed, options.Picture, isLockStep, [.. RecordedSettings(parsed, world)]);
        options = options with { WaitsForAnswers = plan is not null };
        using DriveRecording? recording = plan is { } record
            ? new DriveRecording(terminal.WriteError, record, CommandText.Of(parsed), parsed.GetValue(Overwrite))
            : null;
        using IAwaitableBridge bridge = Bridge.Open(parsed, options, out string place);
        terminal.Out.WriteLine($"Serving at {place}");
        terminal.Out.Flush();
        Func<bool> isDone = parsed.GetValue(Once) ? new OneClient(bridge).IsGone : static () => false;
        var connections = new ConnectionLog(bridge, terminal);
        double duration = parsed.GetValue(Duration) ?? double.PositiveInfinity;
        (long Frames, double Metres, double Seconds, string? Fault) served;
        if (isLockStep)
        {
            var serving = new LockStepGame(bridge, restart => restart is null ? first : Build(current = Restarted(world, restart)), Connect)
            {
                Connections = connections,
                IsDone = isDone,
            };
            string? ending = serving.Run(duration, cancellation);
            served = (serving.Frames, serving.Metres, serving.Seconds, ending);
        }
        else
        {
            using GameEndpoint game = Connect(first);
            DrivingStatus status = new ServedGame(first, game) { Connections = connections, IsDone = isDone }.Run(duration, cancellation);
            served = (status.Frames, game.Metres, first.Ports.World.TimeSeconds, status.Ending);
        }

        terminal.Out.WriteLine(
            FormattableString.Invariant($"{Counted.Of(served.Frames, "frame")}, {served.Metres:0} m driven in {served.Seconds:0.0} s")
        );
        if (recording is not null)
        {
            terminal.Out.WriteLine(recording.Finish());
        }
        if (served.Fault is { } fault)
        {
            throw new GameFaultException(fault);
        }

        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;

        GameEndpoint Connect(SimulatedGame game)
        {
            FixedRoads roads = new(game.Roads, "simulation");
            return new GameEndpoint(game, roads, options, bridge, controller.New, !parsed.GetValue(Unassisted))
            {
                Recording = recording?.Of(game, roads, current.TrafficSeed ?? current.Seed, TownOf(current)),
            };
        }
    }

    /// <summary>The world of a restart: its seed decides traffic, people, route and start, in the town of the command line.</summary>
    private static SimulationOptions Restarted(SimulationOptions world, RestartMessage restart) =>
        world with
        {
            Seed = restart.Town ?? world.Seed,
            TrafficSeed = restart.Seed,
            StartSeed = restart.Seed,
        };

    /// <summary>The setting that tells a restart's town, which has a seed of its own.</summary>
    private static IEnumerable<KeyValuePair<string, string>> TownOf(SimulationOptions world)
    {
        if (world.TrafficSeed is not null && world.Roads is null)
        {
            yield return new("town", world.Seed.ToString(CultureInfo.InvariantCulture));
        }
    }

    private SimulationOptions WorldOf(ParseResult parsed)
    {
        string weather = parsed.GetRequiredValue(WeatherName);
        return new SimulationOptions
        {
            Seed = parsed.GetValue(Seed),
            Roads = parsed.GetValue(Roads) is { } roads ? RoadImporter.Import(roads.FullName).Network : null,
            Near = parsed.GetValue(Near),
            TrafficDensity = parsed.GetValue(Traffic),
            PedestrianDensity = parsed.GetValue(Traffic),
            TrafficRadiusMetres = parsed.GetValue(TrafficRadius),
            Weather = WeatherNames.IsKnown(weather)
                ? weather
                : throw new UsageException($"--weather takes one of {string.Join(", ", WeatherNames.All)}, not '{weather}'."),
            WindowAspect = parsed.GetValue(Size).Aspect,
        };
    }

    private IEnumerable<KeyValuePair<string, string>> RecordedSettings(ParseResult parsed, SimulationOptions world)
    {
        yield return new("weather", world.Weather);
        yield return new("roads", parsed.GetValue(Roads)?.Name ?? "town");
        yield return new("traffic", world.TrafficDensity.ToString(CultureInfo.InvariantCulture));
        yield return new("pedestrians", world.PedestrianDensity.ToString(CultureInfo.InvariantCulture));
        yield return new("bridge", parsed.GetValue(LockStep) ? "lockstep" : "realTime");
        yield return new("assisted", parsed.GetValue(Unassisted) ? "off" : "on");
    }

    private static SimulatedGame Build(SimulationOptions options)
    {
        try
        {
            return new SimulatedGame(options);
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
