using System.CommandLine;
using Harvester.Datasets.Exports;

namespace Harvester.Cli.Commands;

/// <summary>harvester merge: the shards of an export become one dataset.</summary>
internal static class MergeCommand
{
    private const string Notes =
        "The dataset is byte for byte the one that an export without shards gives. The shards' folders stay as they are, unless the dataset is\n"
        + "made in one of them.\n\n"
        + "Examples:\n"
        + "  harvester merge coco-1 coco-2 coco-3 --out coco\n"
        + "  harvester merge coco --out coco        # all shards were written to one folder";

    public static Command Create(Terminal terminal)
    {
        var shards = new Argument<string[]>("SHARD") { Description = "Folders with shards of one export", Arity = ArgumentArity.OneOrMore };
        var output = new Option<string>("--out") { Description = "Folder to write the dataset to", HelpName = "DIR", Required = true };
        var images = new Option<ImageTransfer>("--images") { Description = "Whether files are hard links, where that can be done, or copies" };
        var command = new Command("merge", "Make one dataset of the shards of an export.") { shards, output, images };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            string folder = parsed.GetRequiredValue(output);
            ExportResult result = DatasetMerger.Merge(parsed.GetRequiredValue(shards), folder, parsed.GetValue(images));
            terminal.Out.WriteLine($"{folder}: {result.Frames} frames, {result.Objects} objects");
            return ExitCode.Done;
        });
        return command;
    }
}
