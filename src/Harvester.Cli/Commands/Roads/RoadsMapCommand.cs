using System.CommandLine;
using System.Globalization;
using System.IO.Compression;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Reports.Maps;
using Harvester.Runs.Faults;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads map: draws road data.</summary>
internal static class RoadsMapCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads map session/scenes/roads.csv --out map.png --size 4000";

    private const string Legend =
        "highways orange, one-way roads blue, streets grey, unpaved roads brown, roads that are not drivable light grey, "
        + "water light blue";

    private const string NoRoads = "The road data has no roads to draw.";
    private const int DefaultSize = 2000;
    private const int MaxSize = 20_000;

    // The limit of Math.Round.
    private const int MaxDecimals = 15;

    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output("Image to write: .png or .svg");
        Option<int> size = ValueParsers.Integer("--size", "PIXELS", "Length of the longer side, pixels", 16, MaxSize);
        size.DefaultValueFactory = _ => DefaultSize;
        Option<Box2D?> area = ValueParsers.Optional<Box2D>(
            "--area",
            "XMIN,YMIN,XMAX,YMAX",
            "Part of the world to draw, metres [default: all]",
            ParseArea,
            "the west, south, east and north edges, e.g. -500,-1500,1000,0"
        );
        var command = new Command("map", "Draw road data as a map.") { from, lanesIn, output, size, area };
        HelpWithNotes.AddTo(command, $"Colours: {Legend}.\n\n" + RoadSourceArgument.NotesWith("FROM is", Example));
        command.SetAction(parsed =>
        {
            string file = parsed.GetRequiredValue(output);
            string extension = Path.GetExtension(file).ToUpperInvariant();
            if (extension is not (".PNG" or ".SVG"))
            {
                throw new UsageException("--out takes a file that ends in .png or .svg.");
            }

            RoadNetwork network = RoadSourceArgument.Import(parsed, from, lanesIn, terminal).Network;
            if (network.Nodes.Count == 0)
            {
                throw new UsageException(NoRoads);
            }

            Box2D? part = parsed.GetValue(area);
            var map = new RoadMap(network, part, parsed.GetValue(size));
            if (!map.HasRoads)
            {
                throw new UsageException(
                    part is null ? NoRoads : "There are no roads in --area. Choose another area, or omit the option to draw all roads."
                );
            }

            OutputFile.Write(file, stream => Write(map, extension, stream));
            string metres = ThreeDigits(map.MetresPerPixel).ToString("0.###############", CultureInfo.InvariantCulture);
            terminal.Out.WriteLine($"{file}: {map.Size.Width} x {map.Size.Height} pixels of {metres} m; {Legend}");
            return ExitCode.Done;
        });
        return command;
    }

    private static void Write(RoadMap map, string extension, Stream stream)
    {
        if (extension == ".PNG")
        {
            new PngEncoder(CompressionLevel.Optimal).Write(map.Draw(), stream);
            return;
        }

        map.WriteSvg(stream);
    }

    /// <summary>A length rounded to three significant digits, or to whole metres if it has more digits before the point.</summary>
    private static double ThreeDigits(double metres) =>
        Math.Round(metres, Math.Clamp(2 - (int)Math.Floor(Math.Log10(metres)), 0, MaxDecimals));

    private static Box2D? ParseArea(string text) =>
        NumberText.ReadList(text, 4) is { } n && n[0] < n[2] && n[1] < n[3] ? new Box2D(n[0], n[1], n[2], n[3]) : null;
}
