using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Datasets.Sharding;
using Harvester.Exports.Assembly;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester merge: merges the shards of parallel runs into one session or dataset.</summary>
internal static class MergeCommand
{
    private const string Notes =
        "The result is byte-identical to that of a single run. The shards are not changed, unless --out is the folder of a shard of an\n"
        + "export. If the command was stopped, the same command with --resume continues with the first frame that is not whole.\n"
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
            Arity = ArgumentArity.OneOrMore,
        };
        var output = new Option<string>("--out")
        {
            Description = "Folder to write the result to",
            HelpName = "DIR",
            Required = true,
        };
        Option<ImageTransfer> images = TransferOption.Create("files");
        Option<SyncMode> sync = SyncOption.Create();
        Option<long?> minFree = MinFreeOption.Create();
        Option<bool> resume = ResumeOption.Create();
        Option<bool> noReport = ReportOption.Create();
        var command = new Command("merge", "Merge the shards of parallel runs into one session or dataset.")
        {
            shards,
            output,
            resume,
            images,
            sync,
            minFree,
            noReport,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(
                    Run(
                        terminal,
                        parsed.GetRequiredValue(shards),
                        parsed.GetRequiredValue(output),
                        CommandText.Of(parsed),
                        !parsed.GetValue(noReport),
                        new MergeOptions(
                            parsed.GetValue(images),
                            parsed.GetValue(sync),
                            parsed.GetValue(resume),
                            MinFreeOption.BytesIn(parsed, minFree),
                            cancellation
                        )
                    )
                )
        );
        return command;
    }

    private static int Run(Terminal terminal, string[] shards, string folder, string command, bool withReport, MergeOptions options)
    {
        if (shards.FirstOrDefault(shard => !Directory.Exists(shard)) is { } absent)
        {
            throw new DirectoryNotFoundException($"Folder not found: '{absent}'.");
        }

        if (!shards.Any(SessionMerger.IsSession))
        {
            using FolderLock dataset = FolderLock.Take(folder);
            OutputDisk.Check(folder, "--out", options.MinFreeBytes);
            terminal.Out.WriteLine(ExportSummary.Of(folder, DatasetMerger.Merge(shards, folder, options)));
            return ExitCode.Done;
        }

        if (options.Resume && FinishedResult.Of(folder, () => SessionMerger.FramesOfFinished(shards, folder)) is { } done)
        {
            terminal.Out.WriteLine($"{folder}: {Counted.Of(done, "frame")}; the merge is finished already.");
            return ExitCode.Done;
        }

        using var session = new SessionOutput(
            terminal.WriteError,
            folder,
            command,
            overwrite: null,
            keepsFrames: false,
            options.Resume,
            minFreeBytes: options.MinFreeBytes
        );
        string written = session.Begin();
        int frames = session.Writing(() => SessionMerger.Merge(shards, written, options));
        if (withReport)
        {
            new ReportWriter(new SessionReader(folder)).Write(Path.Combine(folder, ReportWriter.FileName));
        }

        session.Complete();
        terminal.Out.WriteLine($"{folder}: {Counted.Of(frames, "frame")}");
        return ExitCode.Done;
    }
}
