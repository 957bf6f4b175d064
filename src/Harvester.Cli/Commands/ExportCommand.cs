using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Datasets.Roads;
using Harvester.Exports;
using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester export: exports sessions to a dataset format.</summary>
internal sealed class ExportCommand
{
    private static readonly string Notes =
        "Formats (docs/exports has a page on each):\n"
        + string.Concat(DatasetFormats.All.Select(format => $"  {format.Name, -16}{format.Description}\n"))
        + "\nParts are the faces of signs and the heads of traffic lights:\n"
        + "  faces   faces and heads, without their posts\n"
        + "  none    whole signs and lights, with their posts\n"
        + "  all     both\n"
        + "  only    faces and heads, and no other objects\n\n"
        + "2D boxes:\n"
        + "  visible   around the visible pixels; needs masks\n"
        + "  whole     around all pixels of the object in the image, hidden ones included; needs amodal masks\n"
        + "  cuboid    around the part of the cuboid in the image\n"
        + "  amodal    around the whole cuboid, including what lies outside the image\n\n"
        + "An option that has no effect in the format is an error. To continue an interrupted export, run the same command again, with or\n"
        + "without --resume: frames whose files are whole are kept. The shards of an export may go to one folder or to several; harvester\n"
        + "merge combines them. The same sessions and options give the same bytes.\n\n"
        + "Examples:\n"
        + "  harvester export out --format kitti --out kitti\n"
        + "  harvester export day night --format coco --out coco --split train:0.8,val:0.2 --seed 3 --min-visible 0.2\n"
        + "  harvester export out --format kitti --out kitti --map bus=Truck,motorcycle=Cyclist\n"
        + "  harvester export out --format yolo --out yolo --boxes cuboid --subclasses mutcd,light\n"
        + "  harvester export out --format yolo --out yolo --shard 2/8";

    private Argument<string[]> Sessions { get; } = new("SESSION") { Description = "Folders of sessions", Arity = ArgumentArity.OneOrMore };

    private Option<string> Format { get; } =
        new("--format")
        {
            Description = "Dataset format: " + NamesOf(_ => true),
            HelpName = "F",
            Required = true,
        };

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write the dataset to",
            HelpName = "DIR",
            Required = true,
        };
    private Option<bool> Resume { get; } =
        new(ResumeOption.Name) { Description = "Continue an unfinished export (the default for exports)" };

    private Option<string> Splits { get; } =
        new("--split")
        {
            Description = "Splits and their fractions, e.g. train:0.8,val:0.2",
            HelpName = "NAME:FRACTION,...",
            DefaultValueFactory = _ => "train:1",
        };

    private Option<int> Seed { get; } =
        ValueParsers.Integer("--seed", "N", "Random seed of the assignment of places to splits [default: 0]", 0, int.MaxValue);
    private Option<int> Block { get; } =
        ValueParsers.Integer(
            "--split-block",
            "N",
            "Assign blocks of N consecutive frames to splits, and not whole places",
            1,
            int.MaxValue
        );

    private Option<string?> Classes { get; } = ClassList.Option("Export");
    private Option<double> MinVisible { get; } =
        ValueParsers.Number(
            "--min-visible",
            "FRACTION",
            "Export objects with at least this fraction visible, 0 to 1 [default: 0]",
            value => value is >= 0 and <= 1,
            "a number from 0 to 1"
        );

    private Option<PartSelection?> Parts { get; } =
        ValueParsers.OptionalChoice<PartSelection>(
            "--parts",
            "How signs and traffic lights are exported, see below [default: faces; all in "
                + $"{NamesOf(format => format.DefaultParts == PartSelection.All)}]"
        );

    private Option<BoxKind?> Boxes { get; } =
        ValueParsers.OptionalChoice<BoxKind>(
            "--boxes",
            "2D boxes to export, see below [default: visible where there are masks, else cuboid]"
        );

    private Option<string?> Map { get; } = ClassMap.Option();

    private Option<string?> SubclassesOf { get; } =
        new("--subclasses")
        {
            Description = "Split signs into classes by MUTCD code (mutcd), traffic lights by state (light), or both",
            HelpName = "mutcd,light",
        };

    private Option<SegmentationKind> Segmentation { get; } =
        ValueParsers.Choice<SegmentationKind>("--segmentation", "How coco encodes masks [default: rle]");
    private Option<LaneSelection> Lanes { get; } =
        ValueParsers.Choice<LaneSelection>("--lanes", "Lane lines of a frame in tusimple: the five nearest, or all [default: nearest]");
    private Option<FileInfo?> Roads { get; } =
        new("--roads") { Description = "Roads of sessions that do not keep theirs, in openlane-v2, gpudrive and womd", HelpName = "FILE" };
    private Option<ImageTransfer> Images { get; } = TransferOption.Create("images");

    private Option<ImageFormat?> ImageFormat { get; } =
        ImageFormatOption.Format("Convert the images to png, bmp or jpg [default: keep the format]");
    private Option<int?> Quality { get; } = ImageFormatOption.Quality();

    /// <summary>Options that have an effect in some formats only; with any other format they are an error.</summary>
    private (Option Option, Func<DatasetFormat, bool> IsOf)[] OptionsOfFormats =>
        [
            (Segmentation, format => format.HasSegmentations),
            (Lanes, format => format.HasLaneSelection),
            (Roads, format => format.HasMap),
            (Classes, format => format.HasObjects),
            (MinVisible, format => format.HasObjects),
            (Parts, format => format.HasParts),
            (Boxes, format => format.HasBoxes),
            (Map, format => format.HasNames),
            (SubclassesOf, format => format.HasSubclasses),
            (Images, format => format.KeepsImages),
            (Block, format => !format.KeepsSequences),
        ];

    private Option<Shard> ShardOf { get; } = ShardOption.Create();
    private Option<SyncMode> Sync { get; } = SyncOption.Create();
    private Option<long?> MinFree { get; } = MinFreeOption.Create();

    public static Command Create(Terminal terminal) => new ExportCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        var command = new Command("export", "Export sessions to a dataset format.")
        {
            Sessions,
            Format,
            Out,
            Resume,
            Splits,
            Seed,
            Block,
            Classes,
            Map,
            SubclassesOf,
            MinVisible,
            Parts,
            Boxes,
            Segmentation,
            Lanes,
            Roads,
            Images,
            ImageFormat,
            Quality,
            ShardOf,
            Sync,
            MinFree,
        };
        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfExport);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        ExportPlan plan = PlanOf(terminal, parsed, cancellation);
        string folder = parsed.GetRequiredValue(Out);
        Shard shard = parsed.GetValue(ShardOf);
        string part = shard.Count > 1 ? FormattableString.Invariant($".{shard.Number}-of-{shard.Count}") : "";
        using FolderLock held = FolderLock.Take(folder, part);
        OutputDisk.Check(folder, "--out", MinFreeOption.BytesIn(parsed, MinFree));
        int frames = plan.Sessions.Sum(session => session.CountLines()) / shard.Count;
        var exporter = new DatasetExporter(plan, folder, shard, parsed.GetValue(Sync))
        {
            MinFreeBytes = MinFreeOption.BytesIn(parsed, MinFree),
            Resumes = parsed.GetValue(Resume),
        };
        ExportResult result = new JobProgress(terminal, frames).Run(report => exporter.Run(report, cancellation));
        terminal.Out.WriteLine(
            result.IsFinished
                ? ExportSummary.Of(folder, result)
                : $"{folder}: shard {shard} of {plan.Format.Name}, {Counted.Of(result.Frames, "frame")}. {ShardOption.NextStep}"
        );
        if (!plan.Format.HasPoints && plan.Sessions.Any(session => session.ReadInfo().Rig is { Lidars.Count: > 0 }))
        {
            string others = NamesOf(format => format.HasPoints);
            terminal.Out.WriteLine($"{plan.Format.Name} does not have the points of the LiDAR; {others} have them.");
        }

        if (exporter.SeparatedNeighbours > 0)
        {
            terminal.WriteError(
                $"{Counted.Of(exporter.SeparatedNeighbours, "frame")} and the frame before, which look alike, are in "
                    + "different splits. To keep places whole, omit --split-block."
            );
        }

        return ExitCode.Done;
    }

    private ExportPlan PlanOf(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string name = parsed.GetRequiredValue(Format);
        DatasetFormat format =
            DatasetFormats.Find(name) ?? throw new UsageException($"--format takes one of {NamesOf(_ => true)}, not '{name}'.");
        CheckOptions(parsed, format);
        SplitPlan splits = SplitsOf(parsed);
        if (format.ProblemOf(splits.Splits) is { } problem)
        {
            throw new UsageException($"--split: {problem}");
        }

        string[] sessions = parsed.GetRequiredValue(Sessions);
        if (
            sessions
                .GroupBy(folder => Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder)))
                .FirstOrDefault(same => same.Count() > 1) is
            { } twice
        )
        {
            throw new UsageException($"'{twice.First()}' is given twice. Name each session once.");
        }

        var options = new ExportOptions
        {
            Splits = splits,
            Classes = ClassList.Parse(parsed.GetValue(Classes)),
            MinVisibleFraction = parsed.GetValue(MinVisible),
            Parts = parsed.GetValue(Parts),
            Boxes = parsed.GetValue(Boxes),
            Names = ClassMap.Parse(parsed.GetValue(Map), format),
            Subclasses = SubclassesIn(parsed),
            Segmentation = parsed.GetValue(Segmentation),
            Lanes = parsed.GetValue(Lanes),
            Roads = parsed.GetValue(Roads) is { } roads ? RoadImporter.Import(roads.FullName).Network : null,
            RoadsName = parsed.GetValue(Roads)?.Name,
            Images = parsed.GetValue(Images),
            ImageFormat = parsed.GetValue(ImageFormat),
            JpegQuality = ImageFormatOption.QualityOf(parsed, Quality, parsed.GetValue(ImageFormat)),
        };
        return new ExportPlan(format, [.. sessions.Select(folder => RecordedSessions.Open(terminal, folder, cancellation))], options);
    }

    private void CheckOptions(ParseResult parsed, DatasetFormat format)
    {
        foreach ((Option option, Func<DatasetFormat, bool> isOf) in OptionsOfFormats)
        {
            if (parsed.GetResult(option) is { Implicit: false } && !isOf(format))
            {
                string others = NamesOf(isOf);
                throw new UsageException($"{option.Name} has no effect in {format.Name}, only in {others}.");
            }
        }
    }

    private Subclasses SubclassesIn(ParseResult parsed)
    {
        string text = parsed.GetValue(SubclassesOf) ?? "";
        var subclasses = Subclasses.None;
        foreach (string name in text.Split(',', StringSplitOptions.RemoveEmptyEntries))
        {
            subclasses |=
                ValueParsers.ParseChoice<Subclasses>(name) is { } one && one != Subclasses.None
                    ? one
                    : throw new UsageException($"--subclasses takes mutcd, light or mutcd,light, not '{text}'.");
        }

        return subclasses;
    }

    private SplitPlan SplitsOf(ParseResult parsed)
    {
        string text = parsed.GetRequiredValue(Splits);
        IEnumerable<DatasetSplit?> splits = text.Split(',').Select(SplitOf);
        try
        {
            return splits.All(split => split is not null)
                ? new SplitPlan(
                    [.. splits.Select(split => split!.Value)],
                    parsed.GetValue(Seed),
                    parsed.GetResult(Block) is null ? null : parsed.GetValue(Block)
                )
                : throw new UsageException($"--split takes names with fractions, e.g. train:0.8,val:0.2, not '{text}'.");
        }
        catch (ArgumentException e)
        {
            throw new UsageException($"--split: {e.Message}");
        }
    }

    private static DatasetSplit? SplitOf(string text)
    {
        string[] words = text.Split(':');
        return words.Length == 2 && double.TryParse(words[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double share)
            ? new DatasetSplit(words[0].Trim(), share)
            : null;
    }

    private static string NamesOf(Func<DatasetFormat, bool> isOf) =>
        string.Join(", ", DatasetFormats.All.Where(isOf).Select(format => format.Name));
}
