using System.CommandLine;
using System.Text.Json;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Commands;

/// <summary>harvester lanes: prints the lane indicators of a car at a position, as JSON, for checking a frame by hand.</summary>
internal sealed class LanesCommand
{
    private const string Notes =
        "The output has the fields of `lanes` in docs/dataset-format.md, without markings; docs/lanes.md defines them.\n"
        + "The file of --vehicles has one line per vehicle: x,y,z,heading or x,y,z,heading,length, in metres and degrees. The default\n"
        + "length is 4.5.\n\n"
        + "Example:\n"
        + "  harvester lanes --roads data/example-roads.csv --position=-243,68.6,27.2 --heading 1";

    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, NewLine = "\n" };

    private Option<FileInfo> Roads { get; } =
        new("--roads")
        {
            Description = "Road network: any file that harvester roads import reads",
            HelpName = "FILE",
            Required = true,
        };
    private Option<Vector3D> Position { get; } =
        Required(
            ValueParsers.Vector(
                "--position",
                "X,Y,Z",
                "Centre of the car's box in the world, metres; with --box-centre, the car's origin (ego.position)"
            )
        );
    private Option<double> Heading { get; } =
        Required(
            ValueParsers.Number("--heading", "DEG", "Heading of the car, degrees counter-clockwise from north", _ => true, "a number")
        );

    private Option<Vector3D?> BoxCentre { get; } =
        ValueParsers.Optional<Vector3D>(
            "--box-centre",
            "R,F,U",
            "Offset of the box's centre from the car's origin, metres right, forward and up: (modelMin + modelMax) / 2 of ego in a scene "
                + "[default: 0,0,0]",
            text => NumberText.ReadList(text, 3) is { } n ? new Vector3D(n[0], n[1], n[2]) : null,
            "three numbers"
        );

    private Option<FileInfo?> Vehicles { get; } = new("--vehicles") { Description = "Other vehicles, see below", HelpName = "FILE" };
    private Option<double> Length { get; } = WithDefault(Metres("--length", "Length of the car, metres"), 4.5);
    private Option<LookAhead> LaneLookAhead { get; } = LaneOptions.LookAhead();
    private Option<double> Speed { get; } =
        WithDefault(
            ValueParsers.Number(
                "--speed",
                "V",
                "Speed of the car, metres per second, for a look-ahead in seconds",
                value => value is >= 0 and <= 100,
                "a number from 0 to 100"
            ),
            10
        );

    private Option<FileInfo?> Paint { get; } = LaneOptions.Paint();
    private Option<double> LaneWidth { get; } = LaneOptions.LaneWidth();
    private Option<double> NarrowLaneWidth { get; } = LaneOptions.NarrowLaneWidth();

    public static Command Create(Terminal terminal) => new LanesCommand().Build(terminal);

    private ResultCommand Build(Terminal terminal)
    {
        var command = new ResultCommand("lanes", "Print the 13 lane indicators of a car at a position, as JSON.")
        {
            Roads,
            Position,
            Heading,
            BoxCentre,
            Vehicles,
            Length,
            LaneLookAhead,
            Speed,
            Paint,
            LaneWidth,
            NarrowLaneWidth,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            RoadNetwork network = RoadImporter.Import(parsed.GetRequiredValue(Roads).FullName).Network;
            var curves = new RoadCurves(network);
            var observer = new LaneObserver(
                curves,
                new LaneModel(
                    network,
                    parsed.GetValue(LaneWidth),
                    parsed.GetValue(NarrowLaneWidth),
                    parsed.GetValue(Paint) is { } paint ? PaintedSections.Of(PaintFile.Read(paint.FullName, network), curves) : null
                ),
                parsed.GetValue(LaneLookAhead)
            );
            double heading = parsed.GetRequiredValue(Heading);
            var car = new Pose(parsed.GetRequiredValue(Position), Axes.FromHeading(heading));
            LaneObservation seen = observer.Observe(
                car.ToWorld(parsed.GetValue(BoxCentre) ?? Vector3D.Zero),
                heading,
                parsed.GetValue(Speed),
                parsed.GetValue(Length),
                ReadVehicles(parsed.GetValue(Vehicles)),
                null
            );
            terminal.Out.WriteLine(TextOf(seen));
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>The indicators as the command prints them.</summary>
    internal static string TextOf(LaneObservation seen)
    {
        using JsonDocument lanes = JsonDocument.Parse(JsonLabelWriter.Lanes(LanesLabel.Of(seen, "roadFile", [], null)));
        return JsonSerializer.Serialize(lanes.RootElement, Indented);
    }

    /// <summary>Reads the file of --vehicles.</summary>
    /// <param name="file">The file; null for none.</param>
    /// <exception cref="DatasetFormatException">A line is not a vehicle, or there are too many.</exception>
    internal static TrafficVehicle[] ReadVehicles(FileInfo? file)
    {
        const int maxLineCharacters = 1 << 16;
        const int maxVehicles = 10_000;
        const double usualLength = 4.5;
        if (file is null)
        {
            return [];
        }

        var vehicles = new List<TrafficVehicle>();
        foreach ((string line, int index) in InputFile.ReadLines(file.FullName, maxLineCharacters).Select((line, index) => (line, index)))
        {
            if (line.Trim().Length == 0)
            {
                continue;
            }

            double[] numbers =
                NumberText.ReadList(line, 4)
                ?? NumberText.ReadList(line, 5)
                ?? throw new DatasetFormatException(
                    $"{file.Name}, line {index + 1}: expected x,y,z,heading or x,y,z,heading,length, found '{line.Trim()}'."
                );
            if (vehicles.Count == maxVehicles)
            {
                throw new DatasetFormatException($"{file.Name}, line {index + 1}: more than {maxVehicles} vehicles, the limit.");
            }

            vehicles.Add(
                new TrafficVehicle(
                    vehicles.Count + 1,
                    new Vector3D(numbers[0], numbers[1], numbers[2]),
                    numbers[3],
                    numbers.Length > 4 ? numbers[4] : usualLength
                )
            );
        }

        return [.. vehicles];
    }

    private static Option<double> Metres(string name, string description) =>
        ValueParsers.Number(name, "M", description, value => value is > 0 and <= 50, "a number greater than 0 and at most 50");

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
