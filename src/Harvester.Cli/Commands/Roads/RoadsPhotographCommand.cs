using System.CommandLine;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Surveys;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads photograph: photographs roads from above in a simulated game, for roads paint.</summary>
internal sealed class RoadsPhotographCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads photograph --varied-roads --out above";

    /// <summary>Smaller pixels show no whole road, and larger ones lose the narrowest paint, metres.</summary>
    private const double MinMetresPerPixel = 0.02;
    private const double MaxMetresPerPixel = 0.035;
    private const double MinRange = 10;

    private const double WindowAspect = 16.0 / 9;

    private const string Notes =
        "The survey of painted lines that the mod makes in GTA V, in the simulated game: the car is placed at station after station along\n"
        + "the roads, and a camera above it looks straight down, at noon in clear weather, with vehicles, people and signs hidden. The\n"
        + "result is a session, which roads paint measures. The same options and seed give the same bytes; Ctrl+C stops after the current\n"
        + "picture, and the same command with --resume continues.\n\n"
        + "Examples:\n"
        + Example
        + "\n"
        + "  harvester roads photograph --roads data/example-roads.csv --range 200 --out above";

    private readonly Option<string> _out = new("--out")
    {
        Description = "Folder to write the session to",
        HelpName = "DIR",
        Required = true,
    };
    private readonly Option<bool> _overwrite = new("--overwrite") { Description = "Replace an existing session in the folder" };
    private readonly Option<bool> _resume = ResumeOption.Create();
    private readonly Option<int> _seed = ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue);
    private readonly Option<FileInfo?> _roads = new("--roads")
    {
        Description = "Road network, a file or folder [default: a town generated from the seed]",
        HelpName = "FILE",
    };
    private readonly Option<Vector2D?> _near = ValueParsers.Point(
        "--near",
        "X,Y",
        "Middle of the survey, metres [default: the middle of the road network]"
    );
    private readonly Option<double> _range = ValueParsers.Number(
        "--range",
        "M",
        "Photograph roads up to this distance from the middle, metres",
        value => value is >= MinRange and <= SimulatedSurvey.MaxRangeMetres,
        FormattableString.Invariant($"a number from {MinRange} to {SimulatedSurvey.MaxRangeMetres}")
    );
    private readonly Option<double> _metresPerPixel = ValueParsers.Number(
        "--metres-per-pixel",
        "M",
        "Ground in a pixel, metres",
        value => value is >= MinMetresPerPixel and <= MaxMetresPerPixel,
        FormattableString.Invariant($"a number from {MinMetresPerPixel} to {MaxMetresPerPixel}")
    );
    private readonly Option<bool> _variedRoads = new("--varied-roads")
    {
        Description = "Draw lane widths, edge lines and paint at random for each road, by the seed",
    };
    private readonly Option<ImageFormat?> _format = ImageFormatOption.Format("Image format: png, bmp or jpg (lossy) [default: png]");
    private readonly Option<SyncMode> _sync = SyncOption.Create();
    private readonly Option<long?> _minFree = MinFreeOption.Create();

    private RoadsPhotographCommand()
    {
        _seed.DefaultValueFactory = _ => 1;
        _range.DefaultValueFactory = _ => SimulatedSurvey.MaxRangeMetres;
        _metresPerPixel.DefaultValueFactory = _ => SurveyView.UsualMetresPerPixel;
    }

    public static Command Create(Terminal terminal) => new RoadsPhotographCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("photograph", "Photograph roads from above in a simulated game, to measure their paint.")
        {
            _out,
            _overwrite,
            _resume,
            _seed,
            _roads,
            _near,
            _range,
            _metresPerPixel,
            _variedRoads,
            _format,
            _sync,
            _minFree,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                HarvestPlan plan = PlanOf(parsed);
                return Task.FromResult(HarvestRun.Of(terminal, plan, CommandText.Of(parsed), withReport: false, cancellation));
            }
        );
        return command;
    }

    private HarvestPlan PlanOf(ParseResult parsed)
    {
        ResumeOption.Check(parsed.GetValue(_resume), parsed.GetValue(_overwrite));
        int seed = parsed.GetValue(_seed);
        string? roads = parsed.GetValue(_roads)?.FullName;
        RoadNetwork network = roads is null ? TownBuilder.Build(seed) : RoadImporter.Import(roads).Network;
        if (network.Nodes.Count == 0)
        {
            throw new UsageException("The road data has no roads to photograph.");
        }

        Vector2D near = parsed.GetValue(_near) ?? SimulatedSurvey.MiddleOf(network);
        var options = new HarvestOptions();
        var view = new SurveyView(SurveyView.ImageFor(WindowAspect), options.Lens, parsed.GetValue(_metresPerPixel));
        SimulatedSurvey survey = SimulatedSurvey.Of(network, near, view, parsed.GetValue(_range));
        var simulation = new SimulationOptions();
        return new HarvestPlan
        {
            Folder = parsed.GetRequiredValue(_out),
            Overwrite = parsed.GetValue(_overwrite),
            Resume = parsed.GetValue(_resume),
            Survey = survey,
            Options = SurveyOptions.Of(options, view) with
            {
                Format = parsed.GetValue(_format) ?? ImageFormat.Png,
                Sync = parsed.GetValue(_sync),
                MinFreeBytes = MinFreeOption.BytesIn(parsed, _minFree),
            },
            Frames = survey.Plan.Stations.Count,
            Seed = seed,
            FovDegrees = SurveyView.VerticalFovDegrees,
            Roads = roads,
            Props = [],
            Faces = null,
            Near = near,
            Variety = simulation with { HasVariedRoads = parsed.GetValue(_variedRoads), ParkedDensity = simulation.TrafficDensity },
            Weather = "clear",
            TimeOfDay = TimeSpan.FromHours(12),
            DayOfYear = simulation.DayOfYear,
            Detail = Detail.Full,
            LookAhead = LookAhead.Thesis,
            LaneWidth = RoadGeometry.LaneWidth,
            NarrowLaneWidth = RoadGeometry.NarrowLaneWidth,
            Quirks = simulation.Quirks,
            QuirksText = null,
        };
    }
}
