using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Cli.Arguments;
using Harvester.Cli.Harvesting;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Commands;

/// <summary>harvester harvest: a labelled session from a simulated game, with a report.</summary>
internal static class HarvestCommand
{
    private const int MaxFrames = 1_000_000;
    private const double MaxRange = 100_000;
    private const string DistanceForm = "a number greater than 0 and at most 100000";
    private static readonly TimeSpan Noon = TimeSpan.FromHours(12);

    private const string Notes =
        "docs/dataset-format.md describes the session. The same options and seed give the same bytes. Ctrl+C stops after the current frame\n"
        + "and leaves a valid session. A shard is a session with every N-th frame only, under its number in the full run, and without a report;\n"
        + "harvester merge combines all shards.\n\n"
        + "Examples:\n"
        + "  harvester harvest --out out\n"
        + "  harvester harvest --out rain --frames 500 --seed 7 --weather rain --time 18:30 --masks\n"
        + "  harvester harvest --out distorted --k1 -0.05 --focal-scale 1.01\n"
        + "  harvester harvest --out streets --roads nodes.zip --near 0,-1000\n"
        + "  harvester harvest --out part-2 --frames 5000 --shard 2/8";

    private static readonly Option<string> Out =
        new("--out") { Description = "Folder to write the session to", HelpName = "DIR", Required = true };
    private static readonly Option<bool> Overwrite = new("--overwrite") { Description = "Replace an existing session in the folder" };
    private static readonly Option<int> Frames = WithDefault(ValueParsers.Integer("--frames", "N", "Number of frames", 1, MaxFrames), 100);
    private static readonly Option<int> Seed = WithDefault(
        ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);

    private static readonly Option<ImageSize> Size = WithDefault(CameraOptions.SizeOfHarvest(), new ImageSize(800, 600));
    private static readonly Option<ImageFormat?> Format = ImageFormatOption.Format("Image format: png, bmp or jpg (lossy) [default: png]");
    private static readonly Option<int?> Quality = ImageFormatOption.Quality();
    private static readonly Option<double> Fov = WithDefault(CameraOptions.FovOfHarvest(), 50);
    private static readonly Option<double> Hz = WithDefault(
        ValueParsers.Number(
            "--hz",
            "N",
            "Frames per second of game time",
            value => value is > 0 and <= SimulatedHarvest.TicksPerSecond,
            "a number greater than 0 and at most 60"),
        10);

    private static readonly Option<FileInfo?> Roads = new("--roads")
    {
        Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
        HelpName = "FILE",
    };

    private static readonly Option<FileInfo[]> Props = new("--props")
    {
        Description = "Traffic lights and street lamps from this file instead of generated ones; repeatable",
        HelpName = "FILE",
        DefaultValueFactory = _ => [],
    };

    private static readonly Option<FileSystemInfo?> Faces = SpacesOption.Create("the built-in table");

    private static readonly Option<Vector2D?> Near =
        ValueParsers.Point("--near", "X,Y", "Start position, metres [default: the middle of the road network]");
    private static readonly Option<string> WeatherName = new("--weather")
    {
        Description = "Weather: " + string.Join(", ", WeatherNames.All),
        HelpName = "W",
        DefaultValueFactory = _ => "clear",
    };

    private static readonly Option<TimeSpan?> Time = ValueParsers.Optional<TimeSpan>(
        "--time", "HH:MM", "Time of day at the start [default: 12:00]", ParseTime, "a time, e.g. 18:30");

    private static readonly Option<bool> Masks = new("--masks") { Description = "Also write instance masks" };
    private static readonly Option<int> Rays = WithDefault(
        ValueParsers.Integer("--rays", "N", "Rays per frame, spent on masks first, then on objects, faces and lanes", 0,
            LabellingOptions.MaxRays),
        new HarvestOptions().RayBudget);

    private static readonly Option<double> RayReach = WithDefault(
        ValueParsers.Number("--ray-reach", "M", "Objects beyond this distance become regions to ignore, because rays may miss them there, metres", IsDistance, DistanceForm),
        new HarvestOptions().RayReachMetres);

    private static readonly Option<bool> NoScenes =
        new("--no-scenes") { Description = "Write no scenes; the session then cannot be relabelled" };
    private static readonly Option<double> Range = WithDefault(
        ValueParsers.Number("--range", "M", "Label objects up to this distance, metres", IsDistance, DistanceForm), 150);

    private static readonly Option<double> IgnoreRange = WithDefault(
        ValueParsers.Number(
            "--ignore-range",
            "M",
            "Mark visible objects between --range and this distance as regions to ignore, metres; 0 marks none",
            value => value is >= 0 and <= MaxRange,
            "a number from 0 to 100000"),
        new HarvestOptions().IgnoreRangeMetres);

    private static readonly Option<LookAhead> LaneLookAhead = LaneOptions.LookAhead();
    private static readonly Option<double> LaneWidth = LaneOptions.LaneWidth();
    private static readonly Option<double> NarrowLaneWidth = LaneOptions.NarrowLaneWidth();

    private static readonly Option<string?> Classes = ClassList.Option("Label");

    private static readonly Option<string?> Quirks = QuirkList.Option();

    private static readonly Option<string> FreezeBy = FreezeOption.Create();

    private static readonly Option<int> MaxPictureLag = WithDefault(
        ValueParsers.Integer("--max-picture-lag", "TICKS", "Largest allowed picture lag, ticks (1/60 s)", 0, PictureLag.MaxTicks),
        new HarvestOptions().MaxPictureLagTicks);

    private static readonly Option<double> MaxCameraError = WithDefault(
        ValueParsers.Number(
            "--max-camera-error",
            "PX",
            "Largest allowed error of the camera model, pixels; 0 skips the check",
            value => value >= 0,
            "a number, 0 or greater"),
        1);

    private static readonly LensOptions LensOf = new();

    private static readonly Option<Shard> ShardOf = ShardOption.Create();

    private static readonly Option<bool> NoReport = ReportOption.Create();

    public static Command Create(Terminal terminal)
    {
        var command = new Command("harvest", "Harvest a labelled session from a simulated game.")
        {
            Out, Overwrite, Frames, Seed, Size, Format, Quality, Fov, Hz, Roads, Props, Faces, Near, WeatherName, Time, Masks, Rays,
                RayReach, NoScenes, Range, IgnoreRange, LaneLookAhead, LaneWidth, NarrowLaneWidth, Classes, Quirks, FreezeBy,
                    MaxPictureLag, MaxCameraError, ShardOf, NoReport,
        };
        LensOf.AddTo(command);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) =>
            Task.FromResult(Run(terminal, PlanOf(parsed), !parsed.GetValue(NoReport), cancellation)));
        return command;
    }

    private static int Run(Terminal terminal, HarvestPlan plan, bool withReport, CancellationToken cancellation)
    {
        using FolderLock held = FolderLock.Take(plan.Folder);
        OutputFolder.Check(plan.Folder, plan.Overwrite);
        terminal.Out.WriteLine($"Harvesting {(plan.Options.Shard.Count > 1 ? $"shard {plan.Options.Shard} of " : "")}{Counted.Of(plan.Frames, "frame")} of {plan.Options.Image.Width} x {plan.Options.Image.Height}, seed {plan.Seed}, to {plan.Folder}");
        terminal.Out.Flush();
        SimulatedHarvest harvest = SimulatedHarvest.Build(plan, terminal.WriteError);
        OutputFolder.Clear(plan.Folder);
        HarvestOutcome outcome = new JobProgress(terminal, plan.Frames).Run(report => harvest.Run(report, cancellation));
        foreach (string warning in outcome.Warnings)
        {
            terminal.WriteError(warning);
        }

        if (outcome.Fault is { } fault)
        {
            OutputFolder.DiscardUnopened(plan.Folder);
            terminal.WriteError(fault);
            return outcome.ExitCode;
        }

        var session = new SessionReader(plan.Folder);
        string? page = withReport && !outcome.IsCancelled && plan.Options.Shard.Count == 1 ? Path.Combine(plan.Folder, ReportWriter.FileName)
            : null;
        if (page is not null)
        {
            new ReportWriter(session).Write(page);
        }

        HarvestSummary.Write(terminal, plan, outcome, SessionStatistics.Of(session.ReadLabels()), page);
        if (outcome.IsCancelled)
        {
            terminal.WriteError($"Stopped after {outcome.Frames} of {Counted.Of(plan.Frames, "frame")}; the session is valid.");
        }

        return outcome.ExitCode;
    }

    private static HarvestPlan PlanOf(ParseResult parsed)
    {
        string weather = parsed.GetRequiredValue(WeatherName);
        return new HarvestPlan
        {
            Folder = parsed.GetRequiredValue(Out),
            Overwrite = parsed.GetValue(Overwrite),
            Options = OptionsOf(parsed),
            Frames = parsed.GetValue(Frames),
            Seed = parsed.GetValue(Seed),
            FovDegrees = parsed.GetValue(Fov),
            Roads = parsed.GetValue(Roads)?.FullName,
            Props = [.. parsed.GetRequiredValue(Props).Select(file => file.FullName)],
            Faces = parsed.GetValue(Faces) is { } spaces ? Path.TrimEndingDirectorySeparator(spaces.FullName) : null,
            Near = parsed.GetValue(Near),
            Weather = WeatherNames.IsKnown(weather)
                ? weather
                : throw new UsageException($"--weather takes one of {string.Join(", ", WeatherNames.All)}, not '{weather}'."),
            TimeOfDay = parsed.GetValue(Time) ?? Noon,
            LookAhead = parsed.GetValue(LaneLookAhead),
            LaneWidth = parsed.GetValue(LaneWidth),
            NarrowLaneWidth = parsed.GetValue(NarrowLaneWidth),
            Quirks = QuirkList.Parse(parsed.GetValue(Quirks)),
            QuirksAsked = parsed.GetValue(Quirks),
        };
    }

    private static HarvestOptions OptionsOf(ParseResult parsed)
    {
        ImageFormat format = parsed.GetValue(Format) ?? ImageFormat.Png;
        return new HarvestOptions
        {
            Image = parsed.GetValue(Size),
            Format = format,
            JpegQuality = ImageFormatOption.QualityOf(parsed, Quality, format),
            MaxFrames = parsed.GetValue(Frames),
            Shard = parsed.GetValue(ShardOf),
            RateHz = parsed.GetValue(Hz),
            RangeMetres = parsed.GetValue(Range),
            IgnoreRangeMetres = parsed.GetValue(IgnoreRange),
            Classes = ClassList.Parse(parsed.GetValue(Classes)),
            Masks = parsed.GetValue(Masks),
            RayBudget = parsed.GetValue(Rays),
            RayReachMetres = parsed.GetValue(RayReach),
            Lens = LensOf.Parse(parsed),
            MaxCalibrationErrorPixels = parsed.GetValue(MaxCameraError) is > 0 and var error ? error : null,
            MaxPictureLagTicks = parsed.GetValue(MaxPictureLag),
            FreezeBy = FreezeOption.Parse(parsed.GetRequiredValue(FreezeBy)),
            Scenes = !parsed.GetValue(NoScenes),
        };
    }

    private static bool IsDistance(double value) => value is > 0 and <= MaxRange;

    private static TimeSpan? ParseTime(string text) =>
        TimeSpan.TryParseExact(text, [@"hh\:mm", @"h\:mm"], CultureInfo.InvariantCulture, out TimeSpan time) ? time : null;

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
