using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Faces;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Reports.Sessions;
using Harvester.Runs.Faults;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester relabel: recomputes the labels of a session with other options, without the game.</summary>
internal sealed class RelabelCommand
{
    private const string Notes =
        "The recorded session is not changed. Options that are not given keep their recorded values. docs/relabel.md lists which fields\n"
        + "are recomputed, which are kept, and which are null because only the game knows them. If the command was stopped, the same\n"
        + "command with --resume continues after the last frame that is whole and ends with the same bytes.\n\n"
        + "Examples:\n"
        + "  harvester relabel out --out wide --lane-width 3.7 --look-ahead 1s\n"
        + "  harvester relabel out --out near --range 60 --classes car,truck,bus\n"
        + "  harvester relabel drive --out painted --paint paint.csv\n"
        + "  harvester relabel drive --out calibrated --calibration GtaDataHarvester.ini --spaces signs.csv";

    private Argument<string> Session { get; } = SessionArgument.Create();
    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write the new session to",
            HelpName = "DIR",
            Required = true,
        };
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing session in the folder" };
    private Option<bool> Resume { get; } = ResumeOption.Create();
    private Option<double?> Range { get; } =
        Number("--range", "M", "Label objects up to this distance, metres", value => value > 0, "a number greater than 0");
    private Option<string?> Classes { get; } = ClassList.Option("Label");
    private Option<double?> MinArea { get; } =
        Number(
            "--min-box-area",
            "PX2",
            "Label objects whose 2D box has at least this area, square pixels",
            value => value >= 0,
            "a number, 0 or greater"
        );
    private Option<double?> MinSide { get; } =
        Number(
            "--min-box-side",
            "PX",
            "Label objects whose 2D box is at least this wide and high, pixels",
            value => value >= 0,
            "a number, 0 or greater"
        );
    private Option<double?> MaxOccluded { get; } =
        Number(
            "--max-occluded",
            "FRACTION",
            "Label objects with at most this fraction hidden, 0 to 1",
            value => value is >= 0 and <= 1,
            "a number from 0 to 1"
        );
    private Option<FileInfo?> Calibration { get; } =
        File("--calibration", "Lens to label with: a file with the output of harvester calibrate, or the mod's ini file");
    private Option<FileSystemInfo?> Faces { get; } = SpacesOption.Create("the recorded table");
    private Option<FileInfo?> Roads { get; } = File("--roads", "Road network to measure lanes on, a file or folder");
    private Option<LookAhead?> LaneLookAhead { get; } = LaneOptions.OptionalLookAhead();
    private Option<FileInfo?> Paint { get; } = LaneOptions.Paint();
    private Option<double?> LaneWidth { get; } = LaneOptions.OptionalLaneWidth();
    private Option<double?> NarrowLaneWidth { get; } = LaneOptions.OptionalNarrowLaneWidth();
    private Option<ImageTransfer> Images { get; } = TransferOption.Create("images");
    private Option<Shard> ShardOf { get; } = ShardOption.Create();
    private Option<SyncMode> Sync { get; } = SyncOption.Create();
    private Option<long?> MinFree { get; } = MinFreeOption.Create();
    private Option<bool> NoReport { get; } = ReportOption.Create();

    public static Command Create(Terminal terminal) => new RelabelCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("relabel", "Recompute the labels of a session with other options, without the game.")
        {
            Session,
            Out,
            Overwrite,
            Resume,
            Range,
            Classes,
            MinArea,
            MinSide,
            MaxOccluded,
            Calibration,
            Faces,
            Roads,
            LaneLookAhead,
            Paint,
            LaneWidth,
            NarrowLaneWidth,
            Images,
            ShardOf,
            Sync,
            MinFree,
            NoReport,
        };
        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfRelabel);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        SessionReader session = RecordedSessions.Open(terminal, parsed.GetRequiredValue(Session), cancellation);
        string folder = parsed.GetRequiredValue(Out);
        if (string.Equals(Path.GetFullPath(folder), Path.GetFullPath(session.Folder), StringComparison.Ordinal))
        {
            throw new UsageException("--out is the recorded session itself. Name another folder.");
        }

        bool resumes = parsed.GetValue(Resume);
        ResumeOption.Check(resumes, parsed.GetValue(Overwrite));
        RelabelOptions changes = ChangesOf(terminal, session, parsed);
        var relabeller = new SessionRelabeller(session, changes);
        if (resumes && FinishedResult.Of(folder, () => relabeller.FramesOfFinished(folder)) is { } done)
        {
            terminal.Out.WriteLine($"{folder}: {Counted.Of(done, "frame")}; the relabelling is finished already.");
            return ExitCode.Done;
        }

        using var output = new SessionOutput(
            terminal.WriteError,
            folder,
            CommandText.Of(parsed),
            parsed.GetValue(Overwrite),
            keepsFrames: false,
            resumes,
            minFreeBytes: MinFreeOption.BytesIn(parsed, MinFree)
        );
        string written = output.Begin();
        int frames = new JobProgress(terminal, session.CountLines() / changes.Shard.Count).Run(report =>
            output.Writing(() => relabeller.Run(written, report, cancellation))
        );
        bool isShard = changes.Shard.Count > 1;
        if (!isShard && !parsed.GetValue(NoReport))
        {
            new ReportWriter(new SessionReader(written)).Write(Path.Combine(written, ReportWriter.FileName));
        }

        output.Complete();
        terminal.Out.WriteLine(
            isShard
                ? $"{folder}: shard {changes.Shard}, {Counted.Of(frames, "frame")}. {ShardOption.NextStep}"
                : $"{folder}: {Counted.Of(frames, "frame")}"
        );
        return ExitCode.Done;
    }

    private RelabelOptions ChangesOf(Terminal terminal, SessionReader session, ParseResult parsed)
    {
        RoadNetwork? roads = parsed.GetValue(Roads) is { } file ? RoadImporter.Import(file.FullName).Network : null;
        return new RelabelOptions
        {
            RangeMetres = parsed.GetValue(Range),
            Classes = ClassList.Parse(parsed.GetValue(Classes)),
            MinBoxAreaPixels = parsed.GetValue(MinArea),
            MinBoxSidePixels = parsed.GetValue(MinSide),
            MaxOccludedFraction = parsed.GetValue(MaxOccluded),
            Lens = parsed.GetValue(Calibration) is { } calibration ? LensFile.Read(calibration.FullName) : null,
            Faces = parsed.GetValue(Faces) is { } faces
                ? FaceFile.AsWritten(FaceFile.ReadValid(faces.FullName, terminal.WriteError))
                : null,
            FacesName = parsed.GetValue(Faces)?.Name,
            Roads = roads,
            RoadsName = parsed.GetValue(Roads)?.Name,
            LookAhead = parsed.GetValue(LaneLookAhead),
            Paint = PaintOf(session, roads, parsed.GetValue(Paint)),
            PaintName = parsed.GetValue(Paint)?.Name,
            LaneWidthMetres = parsed.GetValue(LaneWidth),
            NarrowLaneWidthMetres = parsed.GetValue(NarrowLaneWidth),
            Images = parsed.GetValue(Images),
            Resume = parsed.GetValue(Resume),
            Shard = parsed.GetValue(ShardOf),
            Sync = parsed.GetValue(Sync),
            MinFreeBytes = MinFreeOption.BytesIn(parsed, MinFree),
        };
    }

    private static PaintTable? PaintOf(SessionReader session, RoadNetwork? roads, FileInfo? file) =>
        file is null ? null
        : (roads ?? PaintSurvey.RoadsOf(session)) is { } network ? PaintFile.Read(file.FullName, network)
        : throw new DatasetFormatException(
            $"'{session.Folder}' has no recorded roads. To use measured paint, name a road network with --roads."
        );

    private static Option<double?> Number(string name, string form, string description, Func<double, bool> isAllowed, string allowed) =>
        ValueParsers.Optional<double>(
            name,
            form,
            description,
            text => NumberText.Read(text) is { } value && isAllowed(value) ? value : null,
            allowed
        );

    private static Option<FileInfo?> File(string name, string description) => new(name) { Description = description, HelpName = "FILE" };
}
