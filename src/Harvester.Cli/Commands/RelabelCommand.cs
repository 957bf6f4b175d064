using System;
using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Faces;
using Harvester.Cli.Relabelling;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Relabelling;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Commands;

/// <summary>harvester relabel: recomputes the labels of a session with other options, without the game.</summary>
internal static class RelabelCommand
{
    private const string Notes =
        "The recorded session is not changed. Options that are not given keep their recorded values. docs/relabel.md lists which fields are\n"
        + "recomputed, which are kept, and which are null because only the game knows them.\n\n"
        + "Examples:\n"
        + "  harvester relabel out --out wide --lane-width 3.7 --look-ahead 1s\n"
        + "  harvester relabel out --out near --range 60 --classes car,truck,bus\n"
        + "  harvester relabel drive --out calibrated --calibration GtaDataHarvester.ini --spaces signs.csv";

    private static readonly Argument<string> Session = SessionArgument.Create();
    private static readonly Option<string> Out =
        new("--out") { Description = "Folder to write the new session to", HelpName = "DIR", Required = true };
    private static readonly Option<bool> Overwrite = new("--overwrite") { Description = "Replace an existing session in that folder" };
    private static readonly Option<double?> Range =
        Number("--range", "M", "Label objects up to this distance, metres", value => value > 0, "a number greater than 0");
    private static readonly Option<string?> Classes = ClassList.Option("Label");
    private static readonly Option<double?> MinArea =
        Number("--min-box-area", "PX2", "Label objects whose 2D box has at least this area, square pixels", value =>
            value >= 0, "a number, 0 or greater");
    private static readonly Option<double?> MinSide =
        Number("--min-box-side", "PX", "Label objects whose 2D box is at least this wide and high, pixels", value =>
            value >= 0, "a number, 0 or greater");
    private static readonly Option<double?> MaxOccluded =
        Number("--max-occluded", "S", "Label objects with at most this fraction hidden, 0 to 1", value =>
            value is >= 0 and <= 1, "a number from 0 to 1");
    private static readonly Option<FileInfo?> Calibration =
        File("--calibration", "Lens to label with: a file with the output of harvester calibrate, or the mod's ini file");
    private static readonly Option<FileSystemInfo?> Faces = SpacesOption.Create("the recorded table");
    private static readonly Option<FileInfo?> Roads = File("--roads", "Road network to measure lanes on, a file or folder");
    private static readonly Option<LookAhead?> LaneLookAhead = LaneOptions.OtherLookAhead();
    private static readonly Option<double?> LaneWidth = LaneOptions.OtherLaneWidth();
    private static readonly Option<double?> NarrowLaneWidth = LaneOptions.OtherNarrowLaneWidth();
    private static readonly Option<ImageTransfer> Images =
        new("--images") { Description = "Link images (hard links, where possible) or copy them [default: Link]" };
    private static readonly Option<Shard> ShardOf = ShardOption.Create();
    private static readonly Option<bool> NoReport = ReportOption.Create();

    public static Command Create(Terminal terminal)
    {
        var command = new Command("relabel", "Recompute the labels of a session with other options, without the game.")
        {
            Session, Out, Overwrite, Range, Classes, MinArea, MinSide, MaxOccluded, Calibration, Faces, Roads, LaneLookAhead, LaneWidth,
                NarrowLaneWidth, Images, ShardOf, NoReport,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private static int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        SessionReader session = RecordedSessions.Open(terminal, parsed.GetRequiredValue(Session));
        string folder = parsed.GetRequiredValue(Out);
        if (string.Equals(Path.GetFullPath(folder), Path.GetFullPath(session.Folder), StringComparison.Ordinal))
        {
            throw new UsageException("--out is the recorded session itself, which stays as it is. Name another folder.");
        }

        using FolderLock held = FolderLock.Take(folder);
        OutputFolder.Check(folder, parsed.GetValue(Overwrite));
        RelabelOptions changes = ChangesOf(terminal, parsed);
        var relabeller = new SessionRelabeller(session, changes);
        OutputFolder.Clear(folder);
        int frames = new JobProgress(terminal, session.CountLines() / changes.Shard.Count)
            .Run(report => relabeller.Run(folder, report, cancellation));
        if (changes.Shard.Count > 1)
        {
            terminal.Out.WriteLine($"{folder}: shard {changes.Shard}, {Counted.Of(frames, "frame")}. When all are done: harvester merge");
            return ExitCode.Done;
        }

        if (!parsed.GetValue(NoReport))
        {
            new ReportWriter(new SessionReader(folder)).Write(Path.Combine(folder, ReportWriter.FileName));
        }

        terminal.Out.WriteLine($"{folder}: {Counted.Of(frames, "frame")}");
        return ExitCode.Done;
    }

    private static RelabelOptions ChangesOf(Terminal terminal, ParseResult parsed) => new()
    {
        RangeMetres = parsed.GetValue(Range),
        Classes = ClassList.Parse(parsed.GetValue(Classes)),
        MinBoxAreaPixels = parsed.GetValue(MinArea),
        MinBoxSidePixels = parsed.GetValue(MinSide),
        MaxOccludedFraction = parsed.GetValue(MaxOccluded),
        Lens = parsed.GetValue(Calibration) is { } calibration ? LensFile.Read(calibration.FullName) : null,
        Faces = parsed.GetValue(Faces) is { } faces ? FaceFile.AsWritten(FaceFile.ReadGood(faces.FullName, terminal.WriteError)) : null,
        FacesName = parsed.GetValue(Faces)?.Name,
        Roads = parsed.GetValue(Roads) is { } roads ? RoadImporter.Import(roads.FullName).Network : null,
        RoadsName = parsed.GetValue(Roads)?.Name,
        LookAhead = parsed.GetValue(LaneLookAhead),
        LaneWidthMetres = parsed.GetValue(LaneWidth),
        NarrowLaneWidthMetres = parsed.GetValue(NarrowLaneWidth),
        Images = parsed.GetValue(Images),
        Shard = parsed.GetValue(ShardOf),
    };

    private static Option<double?> Number(string name, string form, string description, Func<double, bool> isAllowed, string allowed) =>
        ValueParsers.Optional<double>(
            name, form, description, text => ValueParsers.Number(text) is { } value && isAllowed(value) ? value : null, allowed);

    private static Option<FileInfo?> File(string name, string description) => new(name) { Description = description, HelpName = "FILE" };
}
