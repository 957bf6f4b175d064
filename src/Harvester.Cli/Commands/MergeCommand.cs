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
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester merge: merges the shards of parallel runs into one session or dataset.</summary>
internal static class MergeCommand
{
    private const string Notes =
        "The result is byte-identical to that of a single run. The shards are not changed, unless --out is the folder of a shard of an\n"
        + "export. docs/slurm.md shows how to run shards in parallel.\n\n"
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
        Option<ImageTransfer> images = TransferOption.Create("files");
        Option<SyncMode> sync = SyncOption.Create();
        Option<bool> noReport = ReportOption.Create();
        var command = new Command("merge", "Merge the shards of parallel runs into one session or dataset.") { shards, output, images,
            sync, noReport };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            string[] folders = parsed.GetRequiredValue(shards);
            string folder = parsed.GetRequiredValue(output);
            if (folders.FirstOrDefault(shard => !Directory.Exists(shard)) is { } absent)
            {
                throw new DirectoryNotFoundException($"Folder not found: '{absent}'.");
            }

            bool isSession = folders.Any(SessionMerger.IsSession);
            using SessionOutput? session = isSession ? new SessionOutput(terminal, folder, CommandText.Of(parsed), overwrite: null) : null;
            using FolderLock? dataset = isSession ? null : FolderLock.Take(folder);
            terminal.Out.WriteLine(session is not null
                ? MergeSession(folders, folder, session, parsed.GetValue(images), parsed.GetValue(sync), !parsed.GetValue(noReport))
                : MergeDataset(folders, folder, parsed.GetValue(images), parsed.GetValue(sync)));
            return ExitCode.Done;
        });
        return command;
    }

    private static string MergeSession(
        IReadOnlyList<string> shards, string folder, SessionOutput output, ImageTransfer images, SyncMode sync, bool withReport)
    {
        int frames = SessionMerger.Merge(shards, output.Begin(), images, sync);
        if (withReport)
        {
            new ReportWriter(new SessionReader(folder)).Write(Path.Combine(folder, ReportWriter.FileName));
        }

        output.Complete();
        return $"{folder}: {Counted.Of(frames, "frame")}";
    }

    private static string MergeDataset(IReadOnlyList<string> shards, string folder, ImageTransfer images, SyncMode sync) =>
        ExportSummary.Of(folder, DatasetMerger.Merge(shards, folder, images, sync));
}
