using System.CommandLine;
using System.IO;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Masks;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;

namespace Harvester.Cli.Commands.Masks;

/// <summary>harvester masks import: instance maps of another tool become the masks of a session.</summary>
internal static class MasksImportCommand
{
    private const string Notes =
        "DIR has one mask per frame: a 16-bit greyscale PNG of the image's size, named after the frame number (12.png or 00000012.png). A\n"
        + "pixel's value is the id of its label, or 0. With --match, the values may be any numbers that are unique within a frame; each is matched\n"
        + "with the object whose cuboid it overlaps most.\n"
        + "box2dVisible, occludedFraction and visibleFraction are recomputed from the masks, occlusionMethod becomes imported, and an existing\n"
        + "report is rewritten. If any mask is invalid, the session is not changed. docs/pixel-maps.md has details and limits.\n\n"
        + "Examples:\n"
        + "  harvester masks import out stencil-maps\n"
        + "  harvester masks import out stencil-maps --match";

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        var maps = new Argument<string>("DIR") { Description = "Folder with a mask for every frame" };
        var match = new Option<bool>("--match") { Description = "Match the values of the masks with objects by overlap, if they are not the ids of the labels" };
        var command = new Command("import", "Replace the masks of a session by those of another tool.") { folder, maps, match };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) =>
        {
            string session = parsed.GetRequiredValue(folder);
            using FolderLock held = FolderLock.Take(session);
            MaskNumbers numbers = parsed.GetValue(match) ? MaskNumbers.Overlap : MaskNumbers.Ids;
            MaskImport done = MaskImporter.Import(
                RecordedSessions.Open(terminal, session), parsed.GetRequiredValue(maps), numbers, cancellation);
            string report = Path.Combine(session, ReportWriter.FileName);
            if (File.Exists(report))
            {
                new ReportWriter(new SessionReader(session)).Write(report);
            }

            terminal.Out.WriteLine($"{session}: {Counted.Of(done.Frames, "mask")} imported; {done.Seen} of {done.Objects} labelled objects have visible pixels");
            return Task.FromResult(ExitCode.Done);
        });
        return command;
    }
}
