using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Masks;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Masks;

/// <summary>harvester masks import: replaces the masks of a session by those of another tool.</summary>
internal static class MasksImportCommand
{
    /// <summary>The examples in the help.</summary>
    public const string Examples =
        "Examples:\n" + "  harvester masks import out stencil-maps\n" + "  harvester masks import out stencil-maps --match";

    private const string Notes =
        "DIR has one mask per frame: a 16-bit greyscale PNG of the image's size, named after the frame number (12.png or 00000012.png).\n"
        + "The value of a pixel is the id of its label, or 0. With --match, the values may be any numbers that are unique within a frame;\n"
        + "each is matched with the object whose cuboid it overlaps most.\n\n"
        + "box2dVisible, occludedFraction and visibleFraction are recomputed from the masks, occlusionMethod becomes imported, amodal\n"
        + "masks with their boxes are removed, and an existing report is rewritten. If any mask is invalid, the session is not changed.\n"
        + "docs/pixel-maps.md has details and limits.\n\n"
        + Examples;

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        var maps = new Argument<string>("DIR") { Description = "Folder with a mask for every frame" };
        var match = new Option<bool>("--match")
        {
            Description = "Match the values of the masks with objects by overlap, if they are not the ids of the labels",
        };
        Option<SyncMode> sync = SyncOption.Create();
        var command = new Command("import", "Replace the masks of a session with those of another tool.") { folder, maps, match, sync };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                string session = parsed.GetRequiredValue(folder);
                using FolderLock held = FolderLock.Take(session);
                MaskNumbers numbers = parsed.GetValue(match) ? MaskNumbers.Overlap : MaskNumbers.Ids;
                MaskImport done = MaskImporter.Import(
                    RecordedSessions.Open(terminal, session, cancellation),
                    parsed.GetRequiredValue(maps),
                    numbers,
                    RewriteReport,
                    parsed.GetValue(sync),
                    cancellation
                );
                if (done.Leftover is { } leftover)
                {
                    terminal.WriteError(
                        $"The masks are imported, but files of the former session in '{leftover}' cannot be deleted. Delete them yourself."
                    );
                }

                string masks = Counted.Of(done.Frames, "mask");
                terminal.Out.WriteLine($"{session}: {masks} imported; {done.Seen} of {done.Objects} labelled objects have visible pixels");
                if (done.DroppedPixels > 0)
                {
                    terminal.WriteError(DroppedIn(done));
                }

                return Task.FromResult(ExitCode.Done);
            }
        );
        return command;
    }

    private static string DroppedIn(MaskImport done)
    {
        const int maxValues = 10;
        string values =
            string.Join(", ", done.FirstDroppedValues.Take(maxValues)) + (done.FirstDroppedValues.Count > maxValues ? ", ..." : "");
        return FormattableString.Invariant(
            $"{done.DroppedPixels} pixels match no object and are dropped, first in frame {done.FirstFrameWithDropped}: values {values}"
        );
    }

    private static void RewriteReport(SessionReader session)
    {
        string report = Path.Combine(session.Folder, ReportWriter.FileName);
        if (File.Exists(report))
        {
            new ReportWriter(session).Write(report);
        }
    }
}
