using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Props;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Reports.Maps;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads map: draws road data, or writes its lanes for programs that read maps.</summary>
internal static class RoadsMapCommand
{
    /// <summary>The example in the help of all commands for roads.</summary>
    public const string Example = "  harvester roads map session/scenes/roads.csv --out map.png --size 4000";

    private const string LanesExample = "  harvester roads map session/scenes/roads.csv --out town.xodr";

    private const string Legend =
        "highways orange, one-way roads blue, streets grey, unpaved roads brown, roads that are not drivable light grey, "
        + "water light blue";

    private const string LaneLegend =
        "edges of lanes in the colours of roads, ways through junctions purple, stop lines red, crossings grey, lights green";

    private const string NoRoads = "The road data has no roads to draw.";
    private const string NoRoadsInArea = "There are no roads in --area. Choose another area, or omit the option to draw all roads.";

    private const int DefaultSize = 2000;
    private const int MaxSize = 20_000;

    /// <summary>Length of all lanes of a map, metres: several times GTA V's.</summary>
    private const double MaxLaneMetres = 10_000_000;

    // The limit of Math.Round.
    private const int MaxDecimals = 15;

    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output($"File to write; it ends in {RoadMapFormat.Endings}, as the formats below");
        Option<RoadMapFormat?> format = ValueParsers.OptionalOneOf(
            "--format",
            "What to write [default: as the ending of --out says]",
            RoadMapFormat.All,
            each => each.Name
        );
        Option<double> laneWidth = LaneOptions.LaneWidth();
        Option<double> narrowLaneWidth = LaneOptions.NarrowLaneWidth();
        Option<FileInfo?> paint = LaneOptions.Paint();
        Option<int> size = ValueParsers.Integer("--size", "PIXELS", "Images: length of the longer side, pixels", 16, MaxSize);
        size.DefaultValueFactory = _ => DefaultSize;
        Option<Box2D?> area = ValueParsers.Optional<Box2D>(
            "--area",
            "XMIN,YMIN,XMAX,YMAX",
            "Part of the world, metres; lanes: roads that come into it, whole [default: all]",
            ParseArea,
            "the west, south, east and north edges, e.g. -500,-1500,1000,0"
        );
        Option<string[]> props = new("--props")
        {
            Description = "Lanes: lights and signs from a list of props, or from the scenes of a session; repeatable",
            HelpName = "FILE|SESSION",
            DefaultValueFactory = _ => [],
        };
        Option<bool> showLanes = new("--lanes")
        {
            Description = "Images: lanes, ways through junctions, stop lines and lights instead of roads; for a pixel of 0.5 m or less",
        };
        var command = new Command("map", "Draw road data as a map, or write its lanes for programs that read maps.")
        {
            from,
            lanesIn,
            output,
            format,
            size,
            area,
            laneWidth,
            narrowLaneWidth,
            paint,
            props,
            showLanes,
        };
        HelpWithNotes.AddTo(
            command,
            $"Formats:\n{RoadMapFormat.Help}\nColours: {Legend}. With --lanes: {LaneLegend}.\n\n"
                + "Lanes are derived from the road data: docs/maps.md says what is exact and what is not.\n\n"
                + RoadSourceArgument.NotesWith("FROM is", Example, LanesExample)
        );
        command.SetAction(
            (parsed, cancellation) =>
            {
                string file = parsed.GetRequiredValue(output);
                RoadMapFormat kind = parsed.GetValue(format) ?? RoadMapFormat.OfFile(file);
                Option[] idle =
                    kind.Lanes is not null ? [size, showLanes]
                    : parsed.GetValue(showLanes) ? []
                    : [laneWidth, narrowLaneWidth, paint, props];
                if (Array.Find(idle, option => parsed.GetResult(option) is { Implicit: false }) is { } useless)
                {
                    string where = kind.Lanes is not null ? "has an effect on images only" : "has an effect on images with --lanes only";
                    throw new UsageException($"{useless.Name} {where}.");
                }

                RoadNetwork network = RoadSourceArgument.Import(parsed, from, lanesIn, terminal).Network;
                if (network.Nodes.Count == 0)
                {
                    throw new UsageException(NoRoads);
                }

                LaneNetwork Lanes()
                {
                    CheckLength(network);
                    var curves = new RoadCurves(network);
                    PaintTable? table = parsed.GetValue(paint) is { } painted ? PaintFile.Read(painted.FullName, network) : null;
                    var model = new LaneModel(
                        network,
                        parsed.GetValue(laneWidth),
                        parsed.GetValue(narrowLaneWidth),
                        table is null ? null : PaintedSections.Of(table, curves)
                    );
                    PropPlacement[] placed = [.. parsed.GetRequiredValue(props).SelectMany(from => PropsOf(from, terminal, cancellation))];
                    var content = new MapContent
                    {
                        Paint = table,
                        Props = MapProps.Of(placed),
                        SpeedSigns = MapProps.SpeedSignsOf(placed),
                    };
                    try
                    {
                        return LaneNetwork.Of(curves, model, content, parsed.GetValue(area));
                    }
                    catch (FormatException e)
                    {
                        throw new UsageException($"No map can be made: {e.Message}");
                    }
                }

                Box2D? part = parsed.GetValue(area);
                if (kind.Lanes is { } lanesFormat)
                {
                    LaneNetwork lanes = Lanes();
                    if (lanes.Lanes.Count == 0)
                    {
                        throw new UsageException(part is null ? NoRoads : NoRoadsInArea);
                    }

                    OutputFile.Write(file, stream => lanesFormat.Write(lanes, Path.GetFileNameWithoutExtension(file), stream));
                    terminal.Out.WriteLine($"{file}: {Summary(lanes)}");
                    return Task.FromResult(ExitCode.Done);
                }

                Draw(
                    new RoadMap(network, part, parsed.GetValue(size), parsed.GetValue(showLanes) ? Lanes() : null),
                    part,
                    kind,
                    file,
                    terminal
                );
                return Task.FromResult(ExitCode.Done);
            }
        );
        return command;
    }

    private static string Summary(LaneNetwork map)
    {
        MapJunction[] junctions = [.. map.Junctions.Where(junction => junction.Ways.Count > 0)];
        return $"{Counted.Of(map.Segments.Count, "road")} with "
            + $"{Counted.Of(map.Segments.Sum(road => road.Forward.Count + road.Backward.Count), "lane")}, "
            + $"{Counted.Of(junctions.Length, "junction")} with {Counted.Of(junctions.Sum(junction => junction.Ways.Count), "way")}, "
            + $"{Counted.Of(map.Signals.Count, "signal")}, {Counted.Of(map.StopLines.Count, "stop line")}, "
            + Counted.Of(map.Crossings.Count, "crossing");
    }

    private static IReadOnlyList<PropPlacement> PropsOf(string path, Terminal terminal, CancellationToken cancellation) =>
        Directory.Exists(path) ? SessionProps.Of(RecordedSessions.Open(terminal, path, cancellation)) : PropPlacementImporter.Import(path);

    private static void CheckLength(RoadNetwork network)
    {
        double metres = network.Links.Sum(link => (link.LanesForward + link.LanesBackward) * LengthOf(network, link));
        if (metres > MaxLaneMetres)
        {
            throw new UsageException(
                FormattableString.Invariant(
                    $"The road data has {metres / 1000:0} km of lanes; a map takes {MaxLaneMetres / 1000:0} km at most."
                )
            );
        }
    }

    private static double LengthOf(RoadNetwork network, RoadLink link) =>
        (network.Nodes[link.To].Position - network.Nodes[link.From].Position).Length;

    private static void Draw(RoadMap map, Box2D? area, RoadMapFormat format, string file, Terminal terminal)
    {
        if (!map.HasRoads)
        {
            throw new UsageException(area is null ? NoRoads : NoRoadsInArea);
        }

        OutputFile.Write(file, stream => format.WriteImage!(map, stream));
        string metres = ThreeDigits(map.MetresPerPixel).ToString("0.###############", CultureInfo.InvariantCulture);
        terminal.Out.WriteLine(
            $"{file}: {map.Size.Width} x {map.Size.Height} pixels of {metres} m; {(map.ShowsLanes ? LaneLegend : Legend)}"
        );
    }

    /// <summary>A length rounded to three significant digits, or to whole metres if it has more digits before the point.</summary>
    private static double ThreeDigits(double metres) =>
        Math.Round(metres, Math.Clamp(2 - (int)Math.Floor(Math.Log10(metres)), 0, MaxDecimals));

    private static Box2D? ParseArea(string text) =>
        NumberText.ReadList(text, 4) is { } n && n[0] < n[2] && n[1] < n[3] ? new Box2D(n[0], n[1], n[2], n[3]) : null;
}
