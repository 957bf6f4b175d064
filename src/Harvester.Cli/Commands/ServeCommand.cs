using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Capture.Ports;
using Harvester.Cli.Arguments;
using Harvester.Cli.Driving;
using Harvester.Cli.Harvesting;
using Harvester.Cli.Serving;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Commands;

/// <summary>harvester serve: serves the simulated game to a driving program over the live bridge.</summary>
internal static class ServeCommand
{
    private const string Notes =
        "docs/bridge.md describes the protocol; examples/ has two clients in Python. The game runs in real time; a client that requests single\n"
        + "steps gets them as fast as the machine allows.\n\n"
        + "Examples:\n"
        + "  harvester serve\n"
        + "  harvester serve --seed 7 --traffic 0 --port 5000 --duration 600\n"
        + "  harvester serve --folder shared --roads nodes.zip --near 0,-1000";

    private static readonly BridgeOptions Bridge = new();
    private static readonly Option<int> Seed = WithDefault(ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);
    private static readonly Option<FileInfo?> Roads = new("--roads")
    {
        Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
        HelpName = "FILE",
    };

    private static readonly Option<Vector2D?> Near =
        ValueParsers.Point("--near", "X,Y", "Start position, metres [default: the middle of the road network]");
    private static readonly Option<double> Traffic = WithDefault(
        ValueParsers.Number("--traffic", "F", "Factor on the number of vehicles and pedestrians", value =>
            value is >= 0 and <= 10, "a number from 0 to 10"), 1);

    private static readonly Option<string> WeatherName = new("--weather")
    {
        Description = "Weather: " + string.Join(", ", WeatherNames.All),
        HelpName = "W",
        DefaultValueFactory = _ => "clear",
    };

    private static readonly Option<ImageSize> Size = WithDefault(CameraOptions.SizeOfHarvest(), new DrivingOptions().Picture);
    private static readonly Option<double> Hz = WithDefault(
        ValueParsers.Number(
            "--hz", "N", "Frames per second of game time", value =>
                value is > 0 and <= SimulatedHarvest.TicksPerSecond, "a number greater than 0 and at most 60"), 10);

    private static readonly Option<double?> Duration = ValueParsers.Optional<double>(
        "--duration", "S", "Stop after this much game time, seconds [default: serve until Ctrl+C]", text =>
            ValueParsers.Number(text) is > 0 and var seconds ? seconds : null, "a number greater than 0");

    private static readonly ControllerOptions Controller = new("The controller that drives when a program sends indicators", "deepdriving");

    private static readonly Option<bool> Unassisted = new("--unassisted")
    {
        Description = "Let the program drive through junctions too, where the indicators are undefined [default: the built-in driver does]",
    };

    public static Command Create(Terminal terminal)
    {
        var command = new Command("serve", "Serve the simulated game to a driving program over the live bridge.");
        Bridge.AddTo(command);
        foreach (Option option in new Option[] { Seed, Roads, Near, Traffic, WeatherName, Size, Hz, Duration, Unassisted }.Concat(
            Controller.All))
        {
            command.Options.Add(option);
        }

        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private static int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        ControllerPlan controller = Controller.Parse(parsed) with { LookAheadMetres = 0 };
        SimulatedGame simulated = Build(parsed);
        var roads = new FixedRoads(simulated.Roads, "simulation");
        var options = new DrivingOptions { Picture = parsed.GetValue(Size), RateHz = parsed.GetValue(Hz) };
        using IDrivingBridge bridge = Bridge.Open(parsed, options, out string place);
        terminal.Out.WriteLine($"Serving at {place}");
        terminal.Out.Flush();
        using var game = new GameEndpoint(simulated, roads, options, bridge, controller.New, !parsed.GetValue(Unassisted));
        DrivingStatus status = new ServedGame(simulated, game) { Visits = new VisitLog(bridge, terminal) }.Run(
            parsed.GetValue(Duration) ?? double.PositiveInfinity, cancellation);
        terminal.Out.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{Counted.Of(status.Frames, "frame")}, {game.Metres:0} m driven in {simulated.Ports.World.TimeSeconds:0.0} s"));
        if (status.Ending is { } fault)
        {
            throw new GameFaultException(fault);
        }

        return cancellation.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }

    private static SimulatedGame Build(ParseResult parsed)
    {
        string weather = parsed.GetRequiredValue(WeatherName);
        ImageSize size = parsed.GetValue(Size);
        try
        {
            return new SimulatedGame(new SimulationOptions
            {
                Seed = parsed.GetValue(Seed),
                Roads = parsed.GetValue(Roads) is { } roads ? RoadImporter.Import(roads.FullName).Network : null,
                Near = parsed.GetValue(Near),
                TrafficDensity = parsed.GetValue(Traffic),
                PedestrianDensity = parsed.GetValue(Traffic),
                Weather = WeatherNames.IsKnown(weather)
                    ? weather
                    : throw new UsageException($"--weather takes one of {string.Join(", ", WeatherNames.All)}, not '{weather}'."),
                WindowAspect = size.Aspect,
            });
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
