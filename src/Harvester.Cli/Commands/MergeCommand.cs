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

/// <summary>harvester merge: merges the shards of parallel runs into one session or dataset.</summary>
internal static class MergeCommand
{
    private const string Notes =
        "The result is byte-identical to that of a single run. The shards are not changed, unless --out is the folder of a shard of an export.\n"
        + "docs/slurm.md shows how to run shards in parallel.\n\n"
        + "Examples:\n"
        + "  harvester merge out-1 out-2 out-3 --out out\n"
        + "  harvester merge coco-1 coco-2 coco-3 --out coco\n"
        + "  harvester merge coco --out coco        # all shards of an export were written to one folder";

    public static Command Create(Terminal terminal)
    {
        var shards = new Argument<string[]>("SHARD")
        {
            Description = "Folders with the shards of one harvest, relabel or export",
            Arity = ArgumentArity.OneOrMore
        };
        var output = new Option<string>("--out") { Description = "Folder to write the result to", HelpName = "DIR", Required = true };
        var images = new Option<ImageTransfer>("--images") { Description = "Link files (hard links, where possible) or copy them [default: Link]" };
        Option<bool> noReport = ReportOption.Create();
        var command = new Command("merge", "Merge the shards of parallel runs into one session or dataset.") { shards, output, images,
            noReport };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            string[] folders = parsed.GetRequiredValue(shards);
            string folder = parsed.GetRequiredValue(output);
            if (folders.FirstOrDefault(shard => !Directory.Exists(shard)) is { } absent)
            {
                throw new DirectoryNotFoundException($"Folder not found: '{absent}'.");
            }

            using FolderLock held = FolderLock.Take(folder);
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
