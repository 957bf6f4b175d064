using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Exports.Assembly;
using Harvester.Datasets.Files;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Sharding;

namespace Harvester.Cli.Commands;

/// <summary>harvester merge: the shards of a harvest, a relabelling or an export become one session or dataset.</summary>
internal static class MergeCommand
{
    private const string Notes =
        "The result is byte for byte the one that a run without shards gives. The shards' folders stay as they are, unless a dataset is made\n"
        + "in one of them. docs/slurm.md shows how to run shards side by side.\n\n"
        + "Examples:\n"
        + "  harvester merge out-1 out-2 out-3 --out out\n"
        + "  harvester merge coco-1 coco-2 coco-3 --out coco\n"
        + "  harvester merge coco --out coco        # all shards of an export were written to one folder";

    public static Command Create(Terminal terminal)
    {
        var shards = new Argument<string[]>("SHARD") { Description = "Folders with shards of one harvest, relabelling or export", Arity = ArgumentArity.OneOrMore };
        var output = new Option<string>("--out") { Description = "Folder to write the whole to", HelpName = "DIR", Required = true };
        var images = new Option<ImageTransfer>("--images") { Description = "Whether files are hard links, where that can be done, or copies" };
        Option<bool> noReport = ReportOption.Create();
        var command = new Command("merge", "Make one session or dataset of its shards.") { shards, output, images, noReport };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            string[] folders = parsed.GetRequiredValue(shards);
            string folder = parsed.GetRequiredValue(output);
            if (folders.FirstOrDefault(shard => !Directory.Exists(shard)) is { } absent)
            {
                throw new DirectoryNotFoundException($"There is no folder '{absent}'.");
            }

            terminal.Out.WriteLine(folders.Any(SessionMerger.IsSession)
                ? MergeSession(folders, folder, parsed.GetValue(images), !parsed.GetValue(noReport))
                : MergeDataset(folders, folder, parsed.GetValue(images)));
            return ExitCode.Done;
        });
        return command;
    }

    private static string MergeSession(IReadOnlyList<string> shards, string folder, ImageTransfer images, bool withReport)
    {
        int frames = SessionMerger.Merge(shards, folder, images);
        if (withReport)
        {
            new ReportWriter(new SessionReader(folder)).Write(Path.Combine(folder, ReportWriter.FileName));
        }

        return $"{folder}: {Counted.Of(frames, "frame")}";
    }

    private static string MergeDataset(IReadOnlyList<string> shards, string folder, ImageTransfer images) =>
        ExportSummary.Of(folder, DatasetMerger.Merge(shards, folder, images));
}
