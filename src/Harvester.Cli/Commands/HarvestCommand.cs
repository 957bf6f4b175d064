using System.CommandLine;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Commands;

/// <summary>harvester harvest: harvests a labelled session, with a report, from a simulated game.</summary>
internal sealed class HarvestCommand
{
    private const int MaxFrames = 1_000_000;
    private const double MaxRange = 100_000;
    private const string DistanceForm = "a number greater than 0 and at most 100000";

    private const string Notes =
        "docs/dataset-format.md describes the session. The same options and seed give the same bytes. Ctrl+C stops after the current\n"
        + "frame and leaves a valid session. The same command with --resume continues after the last frame, whatever stopped it, and ends\n"
        + "with the same bytes as if it had not been stopped; without --resume it starts over. A shard is a session with every N-th\n"
        + "frame of the full run, under the same frame numbers and without a report; harvester merge combines all shards.\n\n"
        + MaskOption.Notes
        + "\n\n"
        + PairsOption.Notes
        + "\n\n"
        + QuirkList.Notes
        + "\n\n"
        + "Examples:\n"
        + "  harvester harvest --out out\n"
        + "  harvester harvest --out rain --frames 500 --seed 7 --weather rain --time 18:30 --masks\n"
        + "  harvester harvest --out classes --semantics rays\n"
        + "  harvester harvest --out distorted --k1 -0.05 --focal-scale 1.01\n"
        + "  harvester harvest --out streets --roads data/example-roads.csv --places 20\n"
        + "  harvester harvest --out around --rig data/rigs/nuscenes.json --hz 2 --frames 40\n"
        + "  harvester harvest --out pairs --frames 20 --pair-weathers clear,rain --pair-hours 0,6,12 --pair-without nearest-sign\n"
        + "  harvester harvest --out part-2 --frames 5000 --shard 2/8";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write the session to",
            HelpName = "DIR",
            Required = true,
        };
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing session in the folder" };
    private Option<bool> Resume { get; } =
        new("--resume") { Description = "Continue an unfinished session of the same command, or start one" };
    private Option<int> Frames { get; } = WithDefault(ValueParsers.Integer("--frames", "N", "Number of frames", 1, MaxFrames), 100);
    private Option<int> Seed { get; } = WithDefault(ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);

    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new ImageSize(800, 600));
    private Option<ImageFormat?> Format { get; } = ImageFormatOption.Format("Image format: png, bmp or jpg (lossy) [default: png]");
    private Option<int?> Quality { get; } = ImageFormatOption.Quality();
    private Option<double> Fov { get; } = WithDefault(CameraOptions.FovOfHarvest(), 50);
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

    private Option<FileInfo?> Roads { get; } =
        new("--roads")
        {
            Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
            HelpName = "FILE",
        };

    private Option<FileInfo[]> Props { get; } =
        new("--props")
        {
            Description = "Traffic lights and street lamps from this file instead of generated ones; repeatable",
            HelpName = "FILE",
            DefaultValueFactory = _ => [],
        };

    private Option<FileSystemInfo?> Faces { get; } = SpacesOption.Create("the built-in table");

    private Option<Vector2D?> Near { get; } =
        ValueParsers.Point("--near", "X,Y", "Start position, metres [default: the middle of the road network]");
    private LogOption LogOf { get; } = new();
    private VarietyOptions Variety { get; } = new();
    private MomentOptions Moment { get; } = new();

    private Option<string?> Masks { get; } = MaskOption.Create();
    private SemanticsOptions Semantics { get; } = new();

    private ChannelOptions Channels { get; } = new();
    private ImuOptions ImuOf { get; } = new();
    private GnssOptions GnssOf { get; } = new();
    private BirdsEyeOptions BirdsEyeOf { get; } = new();

    private Option<bool> TrueOcclusion { get; } =
        new("--true-occlusion") { Description = "Also label how much of each object the renderer hides, exactly; slower" };

    private Option<int> Rays { get; } =
        WithDefault(
            ValueParsers.Integer(
                "--rays",
                "N",
                "Rays per frame, spent on masks first, then on objects, faces and lanes",
                0,
                LabellingOptions.MaxRays
            ),
            new HarvestOptions().RayBudget
        );

    private Option<double> RayReach { get; } =
        WithDefault(
            ValueParsers.Number(
                "--ray-reach",
                "M",
                "Distance to which rays hit objects reliably, metres; objects beyond it become ignore regions",
                IsDistance,
                DistanceForm
            ),
            new HarvestOptions().RayReachMetres
        );

    private Option<bool> Motion { get; } =
        new("--motion") { Description = "Record the motion of the vehicle at every tick between frames; always recorded with --rig" };

    private EventChoice EventsOf { get; } = new();

    private Option<bool> NoScenes { get; } =
        new("--no-scenes") { Description = "Do not write scenes; the session cannot be relabelled then" };
    private Option<double> Range { get; } =
        WithDefault(ValueParsers.Number("--range", "M", "Label objects up to this distance, metres", IsDistance, DistanceForm), 80);

    private Option<double> IgnoreRange { get; } =
        WithDefault(
            ValueParsers.Number(
                "--ignore-range",
                "M",
                "Mark visible objects between --range and this distance as ignore regions, metres; 0 marks none",
                value => value is >= 0 and <= MaxRange,
                "a number from 0 to 100000"
            ),
            new HarvestOptions().IgnoreRangeMetres
        );

    private Option<LookAhead> LaneLookAhead { get; } = LaneOptions.LookAhead();
    private Option<FileInfo?> Paint { get; } = LaneOptions.Paint();
    private Option<double> LaneWidth { get; } = LaneOptions.LaneWidth();
    private Option<double> NarrowLaneWidth { get; } = LaneOptions.NarrowLaneWidth();

    private Option<string?> Classes { get; } = ClassList.Option("Label");
    private Option<string?> Quirks { get; } = QuirkList.Option();
    private Option<string> DetailOf { get; } = DetailOption.Create();
    private Option<string> FreezeBy { get; } = FreezeOption.Create();

    private Option<int> MaxPictureLag { get; } =
        WithDefault(
            ValueParsers.Integer("--max-picture-lag", "TICKS", "Maximum picture lag, ticks (1/60 s)", 0, PictureLag.MaxTicks),
            new HarvestOptions().MaxPictureLagTicks
        );

    private Option<double> MaxCameraError { get; } =
        WithDefault(
            ValueParsers.Number(
                "--max-camera-error",
                "PX",
                "Maximum error of the camera model, pixels; 0 skips the check",
                value => value >= 0,
                "a number, 0 or greater"
            ),
            1
        );

    private LensOptions LensOf { get; } = new();
    private RigOption RigOf { get; } = new();
    private PairsOption PairsOf { get; } = new();
    private Option<Shard> ShardOf { get; } = ShardOption.Create();
    private Option<SyncMode> Sync { get; } = SyncOption.Create();
    private Option<long?> MinFree { get; } = MinFreeOption.Create();
    private Option<bool> NoReport { get; } = ReportOption.Create();

    public static Command Create(Terminal terminal) => new HarvestCommand().Build(terminal);

    /// <summary>Adds the options of a harvest to a command.</summary>
    public void AddTo(Command command)
    {
        Option[] options =
        [
            Out,
            Overwrite,
            Resume,
            Frames,
            Seed,
            Size,
            Format,
            Quality,
            Fov,
            Hz,
            Roads,
            Props,
            Faces,
            Near,
            Masks,
            TrueOcclusion,
            Rays,
            RayReach,
            NoScenes,
            Motion,
            Range,
            IgnoreRange,
            LaneLookAhead,
            Paint,
            LaneWidth,
            NarrowLaneWidth,
            Classes,
            DetailOf,
            Quirks,
            FreezeBy,
            MaxPictureLag,
            MaxCameraError,
            ShardOf,
            Sync,
            MinFree,
            NoReport,
        ];
        Array.ForEach(options, command.Options.Add);
        Semantics.AddTo(command);
        Channels.AddTo(command);
        ImuOf.AddTo(command);
        GnssOf.AddTo(command);
        BirdsEyeOf.AddTo(command);
        Moment.AddTo(command);
        Variety.AddTo(command);
        LensOf.AddTo(command);
        RigOf.AddTo(command);
        LogOf.AddTo(command);
        EventsOf.AddTo(command);
        PairsOf.AddTo(command);
    }

    /// <summary>Whether the session gets a report.</summary>
    public bool HasReport(ParseResult parsed) => !parsed.GetValue(NoReport);

    /// <summary>The harvest that a command line describes.</summary>
    /// <exception cref="Runs.Faults.UsageException">Options contradict each other.</exception>
    public HarvestPlan PlanOf(ParseResult parsed) => RigOf.AppliedTo(parsed, LogOf.AppliedTo(parsed, PlanWithoutRig(parsed)));

    private Command Build(Terminal terminal)
    {
        var command = new Command("harvest", "Harvest a labelled session from a simulated game.");
        AddTo(command);
        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfHarvest);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(HarvestRun.Of(terminal, PlanOf(parsed), CommandText.Of(parsed), HasReport(parsed), cancellation))
        );
        return command;
    }

    private HarvestPlan PlanWithoutRig(ParseResult parsed)
    {
        ResumeOption.Check(parsed.GetValue(Resume), parsed.GetValue(Overwrite));
        return new HarvestPlan
        {
            Folder = parsed.GetRequiredValue(Out),
            Overwrite = parsed.GetValue(Overwrite),
            Resume = parsed.GetValue(Resume),
            Options = OptionsOf(parsed),
            Frames = parsed.GetValue(Frames),
            Seed = parsed.GetValue(Seed),
            FovDegrees = parsed.GetValue(Fov),
            Roads = parsed.GetValue(Roads)?.FullName,
            Paint = parsed.GetValue(Paint)?.FullName,
            Props = [.. parsed.GetRequiredValue(Props).Select(file => file.FullName)],
            Faces = parsed.GetValue(Faces) is { } spaces ? Path.TrimEndingDirectorySeparator(spaces.FullName) : null,
            Near = parsed.GetValue(Near),
            Variety = Variety.Parse(parsed) with { ReportsTrueOcclusion = parsed.GetValue(TrueOcclusion) },
            Weather = Moment.Weather(parsed),
            DayOfYear = Moment.DayOfYear(parsed),
            TimeOfDay = Moment.TimeOfDay(parsed),
            Detail = DetailOption.Parse(parsed.GetRequiredValue(DetailOf)),
            LookAhead = parsed.GetValue(LaneLookAhead),
            LaneWidth = parsed.GetValue(LaneWidth),
            NarrowLaneWidth = parsed.GetValue(NarrowLaneWidth),
            Quirks = QuirkList.Parse(parsed.GetValue(Quirks)),
            QuirksText = parsed.GetValue(Quirks),
        };
    }

    private HarvestOptions OptionsOf(ParseResult parsed)
    {
        ImageFormat format = parsed.GetValue(Format) ?? ImageFormat.Png;
        MaskMethod? masks = MaskOption.Parse(parsed, Masks, isWhole: parsed.GetValue(ShardOf).Count == 1 && !parsed.GetValue(Resume));
        var options = new HarvestOptions
        {
            Image = parsed.GetValue(Size),
            Format = format,
            JpegQuality = ImageFormatOption.QualityOf(parsed, Quality, format),
            MaxFrames = parsed.GetValue(Frames),
            Places = Variety.Places(parsed, parsed.GetValue(Frames), parsed.GetValue(Near) is not null),
            Shard = parsed.GetValue(ShardOf),
            RateHz = parsed.GetValue(Hz),
            RangeMetres = parsed.GetValue(Range),
            IgnoreRangeMetres = parsed.GetValue(IgnoreRange),
            Classes = ClassList.Parse(parsed.GetValue(Classes)),
            Masks = masks is not null || Semantics.Method(parsed) is not null,
            MaskMethod = masks ?? MaskMethod.Rays,
            Semantics = Semantics.Method(parsed),
            Channels = Channels.Keys(parsed),
            ImuNoise = ImuOf.Parse(parsed, Channels.Keys(parsed).Contains(FrameChannels.Imu.Key), parsed.GetValue(Seed)),
            GnssNoise = GnssOf.Parse(parsed, Channels.Keys(parsed).Contains(FrameChannels.Gnss.Key), parsed.GetValue(Seed)),
            BirdsEye = BirdsEyeOf.Parse(parsed, Channels.Keys(parsed).Contains(FrameChannels.BirdsEye.Key)),
            Materials = Semantics.Materials(parsed),
            RayBudget = parsed.GetValue(Rays),
            RayReachMetres = parsed.GetValue(RayReach),
            Lens = LensOf.Parse(parsed),
            MaxCalibrationErrorPixels = parsed.GetValue(MaxCameraError) is > 0 and var error ? error : null,
            MaxPictureLagTicks = parsed.GetValue(MaxPictureLag),
            FreezeBy = FreezeOption.Parse(parsed.GetRequiredValue(FreezeBy)),
            Scenes = !parsed.GetValue(NoScenes),
            Motion = parsed.GetValue(Motion),
            Events = EventsOf.Parse(parsed),
            Sync = parsed.GetValue(Sync),
            MinFreeBytes = MinFreeOption.BytesIn(parsed, MinFree),
            Pairs = PairsOf.Parse(parsed),
        };
        return (options.KeepProblem ?? options.BirdsEyeProblem ?? options.OccupancyProblem) is { } problem
            ? throw new UsageException(problem)
            : options;
    }

    private static bool IsDistance(double value) => value is > 0 and <= MaxRange;

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
