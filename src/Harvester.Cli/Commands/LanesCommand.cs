using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Text.Json;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Commands;

/// <summary>harvester lanes: the indicators of a car at a place of a road network, as JSON; the tool to check a frame by hand.</summary>
internal static class LanesCommand
{
    private const string Notes =
        "The fields are those of `lanes` in docs/dataset-format.md, without markings; docs/lanes.md says what each means.\n"
        + "A file of vehicles has a line for each: x,y,z,heading and, if known, its length, metres and degrees.\n\n"
        + "Example:\n"
        + "  harvester lanes --roads roads.csv --position -72.6,-1049.5,27.1 --heading 159";

    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, NewLine = "\n" };

    private static readonly Option<FileInfo> Roads = new("--roads") { Description = "The roads: any file that harvester roads import reads", HelpName = "FILE", Required = true };
    private static readonly Option<Vector3D> Position = Required(ValueParsers.Vector("--position", "X,Y,Z", "Middle of the car's box, metres, world; with --box-centre the car's origin, as ego.position"));
    private static readonly Option<double> Heading = Required(
        ValueParsers.Number("--heading", "DEG", "The car's heading, degrees counter-clockwise from north", _ => true, "a number of degrees"));

    private static readonly Option<Vector3D?> BoxCentre = ValueParsers.Optional<Vector3D>(
        "--box-centre",
        "R,F,U",
        "Middle of the car's box from its origin, metres to the right, ahead and up: half the sum of the scene's ego.modelMin and modelMax",
        text => ValueParsers.Numbers(text, 3) is { } n ? new Vector3D(n[0], n[1], n[2]) : null,
        "three numbers");

    private static readonly Option<FileInfo?> Vehicles = new("--vehicles") { Description = "Other vehicles", HelpName = "FILE" };
    private static readonly Option<double> Length = WithDefault(Metres("--length", "The car's length, metres"), 4.5);
    private static readonly Option<LookAhead> LaneLookAhead = LaneOptions.LookAhead();
    private static readonly Option<double> Speed = WithDefault(
        ValueParsers.Number("--speed", "V", "The car's speed, metres per second; for a look-ahead in seconds", value => value is >= 0 and <= 100, "a number from 0 to 100"), 10);

    private static readonly Option<double> LaneWidth = LaneOptions.LaneWidth();
    private static readonly Option<double> NarrowLaneWidth = LaneOptions.NarrowLaneWidth();

    public static Command Create(Terminal terminal)
    {
        var command = new Command("lanes", "Write the lane indicators of a car at a place as JSON.")
        {
            Roads, Position, Heading, BoxCentre, Vehicles, Length, LaneLookAhead, Speed, LaneWidth, NarrowLaneWidth,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            RoadNetwork network = RoadImporter.Import(parsed.GetRequiredValue(Roads).FullName).Network;
            var observer = new LaneObserver(
                new RoadCurves(network), new LaneModel(network, parsed.GetValue(LaneWidth), parsed.GetValue(NarrowLaneWidth)), parsed.GetValue(LaneLookAhead));
            double heading = parsed.GetRequiredValue(Heading);
            var car = new Pose(parsed.GetRequiredValue(Position), Axes.FromHeading(heading));
            LaneObservation seen = observer.Observe(
                car.ToWorld(parsed.GetValue(BoxCentre) ?? Vector3D.Zero), heading, parsed.GetValue(Speed), parsed.GetValue(Length), ReadVehicles(parsed.GetValue(Vehicles)), null);
            using JsonDocument lanes = JsonDocument.Parse(JsonLabelWriter.Lanes(LanesLabel.Of(seen, "roadFile", [], null)));
            terminal.Out.WriteLine(JsonSerializer.Serialize(lanes.RootElement, Indented));
            return ExitCode.Done;
        });
        return command;
    }

    private static TrafficVehicle[] ReadVehicles(FileInfo? file)
    {
        const double usualLength = 4.5;
        if (file is null)
        {
            return [];
        }

        var vehicles = new List<TrafficVehicle>();
        foreach ((string line, int index) in File.ReadLines(file.FullName).Select((line, index) => (line, index)))
        {
            if (line.Trim().Length == 0)
            {
                continue;
            }

            double[] numbers = ValueParsers.Numbers(line, 4) ?? ValueParsers.Numbers(line, 5)
                ?? throw new DatasetFormatException($"{file.Name}, line {index + 1}: x,y,z,heading or x,y,z,heading,length belong here, not '{line.Trim()}'.");
            vehicles.Add(new TrafficVehicle(
                vehicles.Count + 1, new Vector3D(numbers[0], numbers[1], numbers[2]), numbers[3], numbers.Length > 4 ? numbers[4] : usualLength));
        }

        return [.. vehicles];
    }

    private static Option<double> Metres(string name, string description) =>
        ValueParsers.Number(name, "M", description, value => value is > 0 and <= 50, "a number greater than 0, 50 at most");

    private static Option<T> Required<T>(Option<T> option)
    {
        option.Required = true;
        return option;
    }

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
