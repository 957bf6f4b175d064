using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Props;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Sheets;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;
using Harvester.Simulation.World;

namespace Harvester.Cli.Commands;

/// <summary>harvester contact-sheet: one picture with what a harvest sees at several places, weathers and hours.</summary>
internal sealed class ContactSheetCommand
{
    private const int MaxPlaces = 1000;
    private const double MaxSeconds = 600;

    private const string Notes =
        "There is a tile for each place, weather, time of day and moment, with a caption. With several weathers and several times,\n"
        + "each place has a row per weather and a column per time. The camera is that of a harvest. The places are those of --list,\n"
        + "then those of --at, then --places; without any, the middle of the road network. The file of --list has one name,x,y a line,\n"
        + "in metres. The same options and seed give the same bytes.\n\n"
        + "Examples:\n"
        + "  harvester contact-sheet --out town.png --weather clear --weather rain --time 12:00 --time 22:00\n"
        + "  harvester contact-sheet --out streets.png --roads data/example-roads.csv --places 4\n"
        + "  harvester contact-sheet --out drive.png --roads data/example-roads.csv --at=-250,120 --seconds 1 --seconds 5 --seconds 10";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "PNG file to write",
            HelpName = "FILE",
            Required = true,
        };
    private Option<FileInfo?> Roads { get; } =
        new("--roads") { Description = "Road network, a file or folder [default: a town generated from the seed]", HelpName = "FILE" };

    private Option<FileInfo[]> Props { get; } =
        new("--props")
        {
            Description = "Traffic lights and street lamps from this file instead of generated ones; repeatable",
            HelpName = "FILE",
            DefaultValueFactory = _ => [],
        };

    private Option<string[]> At { get; } = Repeatable("--at", "X,Y", "A place, metres; repeatable");
    private Option<FileInfo?> List { get; } = new("--list") { Description = "File with places, see below", HelpName = "FILE" };
    private Option<int> Places { get; } =
        WithDefault(ValueParsers.Integer("--places", "N", "Add N places all over the road network, chosen by the seed", 0, MaxPlaces), 0);

    private Option<string[]> Weathers { get; } =
        Repeatable("--weather", "W", $"Weather: {string.Join(", ", WeatherNames.All)}; repeatable [default: clear]");

    private Option<string[]> Times { get; } = Repeatable("--time", "HH:MM", "Time of day; repeatable [default: 12:00]");
    private Option<string[]> Seconds { get; } =
        Repeatable("--seconds", "S", "How long the ego has driven, seconds; repeatable [default: 1]");

    private Option<int> Seed { get; } = WithDefault(ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);
    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new ImageSize(480, 360));
    private Option<string> Detail { get; } = WithDefault(DetailOption.Create(), DetailOption.Full);
    private Option<double> Fov { get; } = WithDefault(CameraOptions.FovOfHarvest(), 50);

    public static Command Create(Terminal terminal) => new ContactSheetCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("contact-sheet", "Show what a harvest sees at several places, weathers and hours, as one picture.")
        {
            Out,
            Roads,
            Props,
            At,
            List,
            Places,
            Weathers,
            Times,
            Seconds,
            Seed,
            Size,
            Fov,
            Detail,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) => Task.FromResult(Run(terminal, PlanOf(parsed), parsed.GetRequiredValue(Out), cancellation))
        );
        return command;
    }

    private static int Run(Terminal terminal, SheetPlan plan, string file, CancellationToken cancellation)
    {
        SheetLayout layout = SheetLayout.Of(plan);
        using FolderLock? held = OutputFile.Lock(file);
        var sheet = new ContactSheet(layout);
        int tiles = plan.Places.Count * plan.Moments.Count();
        new JobProgress(terminal, tiles, "tiles").Run(report =>
        {
            int done = 0;
            foreach (SheetTile tile in SheetCamera.Take(plan, cancellation))
            {
                sheet.Add(tile);
                report(++done);
            }

            return done;
        });
        AtomicFile.Write(file, stream => new PngEncoder().Write(sheet.Picture, stream));
        terminal.Out.WriteLine(
            $"{file}: {Counted.Of(tiles, "tile")} of {Counted.Of(plan.Places.Count, "place")}, "
                + $"{layout.Sheet.Width} x {layout.Sheet.Height} pixels"
        );
        return ExitCode.Done;
    }

    private SheetPlan PlanOf(ParseResult parsed)
    {
        FileExtension.Check("--out", parsed.GetRequiredValue(Out), ".png");
        string[] weathers =
        [
            .. ValuesOf(parsed, Weathers, "clear")
                .Select(name =>
                    WeatherNames.Find(name)
                    ?? throw new UsageException($"--weather takes one of {string.Join(", ", WeatherNames.All)}, not '{name}'.")
                ),
        ];

        int seed = parsed.GetValue(Seed);
        int spread = parsed.GetValue(Places);
        List<SheetPlace> places = parsed.GetValue(List) is { } list ? PlaceList.Read(list.FullName) : [];
        places.AddRange(parsed.GetRequiredValue(At).Select(PlaceAt));
        TimeSpan[] times = [.. ValuesOf(parsed, Times, "12:00").Select(TimeAt)];
        double[] seconds = [.. ValuesOf(parsed, Seconds, "1").Select(SecondsOf).Order()];
        RoadNetwork? roads = parsed.GetValue(Roads) is { } file ? RoadImporter.Import(file.FullName).Network : null;
        FileInfo[] props = parsed.GetRequiredValue(Props);
        if (spread > 0)
        {
            places.AddRange(SpreadPlaces.Of(roads ?? TownBuilder.Build(seed), spread, seed).Select(place => new SheetPlace("", place)));
        }

        return new SheetPlan
        {
            Roads = roads,
            Props = props.Length > 0 ? [.. props.SelectMany(prop => PropPlacementImporter.Import(prop.FullName))] : null,
            Seed = seed,
            Places = places.Count > 0 ? places : [new SheetPlace("", null)],
            Weathers = weathers,
            Times = times,
            Seconds = seconds,
            Tile = parsed.GetValue(Size),
            FovDegrees = parsed.GetValue(Fov),
            Detail = DetailOption.Parse(parsed.GetRequiredValue(Detail)),
        };
    }

    private static string[] ValuesOf(ParseResult parsed, Option<string[]> option, string otherwise) =>
        parsed.GetRequiredValue(option) is { Length: > 0 } values ? values : [otherwise];

    private static SheetPlace PlaceAt(string text) =>
        NumberText.ReadList(text, 2) is { } at
            ? new SheetPlace("", new Geometry.Vector2D(at[0], at[1]))
            : throw new UsageException($"--at takes two numbers, e.g. 0,-1000, not '{text}'.");

    private static TimeSpan TimeAt(string text) =>
        TimeSpan.TryParseExact(text, [@"hh\:mm", @"h\:mm"], CultureInfo.InvariantCulture, out TimeSpan time)
            ? time
            : throw new UsageException($"--time takes a time of day, e.g. 18:30, not '{text}'.");

    private static double SecondsOf(string text) =>
        NumberText.Read(text) is { } seconds and >= 0 and <= MaxSeconds
            ? seconds
            : throw new UsageException($"--seconds takes a number from 0 to {MaxSeconds}, not '{text}'.");

    private static Option<string[]> Repeatable(string name, string form, string description) =>
        new(name)
        {
            Description = description,
            HelpName = form,
            DefaultValueFactory = _ => [],
        };

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
