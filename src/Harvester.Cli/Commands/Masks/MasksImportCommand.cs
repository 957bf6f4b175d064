using System.CommandLine;
using System.IO;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Masks;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;

namespace Harvester.Cli.Commands.Masks;

/// <summary>harvester masks import: instance maps of another tool become the masks of a session.</summary>
internal static class MasksImportCommand
{
    private const string Notes =
        "DIR has a PNG of 16-bit grey, of the image's size, for every frame, named by the frame's number (12.png or 00000012.png).\n"
        + "Its values are the ids of the labels, 0 for none of them. With --match they may be any numbers that tell the objects of one frame apart;\n"
        + "each is matched with the object whose cuboid it covers best.\n"
        + "Masks, box2dVisible, occludedFraction and visibleFraction are replaced; occlusionMethod becomes imported. A report is made anew.\n"
        + "The session stays as it was if any map is at fault. Meaning and limits: docs/pixel-maps.md.\n\n"
        + "Examples:\n"
        + "  harvester masks import out stencil-maps\n"
        + "  harvester masks import out stencil-maps --match";

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        var maps = new Argument<string>("DIR") { Description = "Folder of the maps" };
        var match = new Option<bool>("--match") { Description = "The numbers are not the labels' ids: find out by overlap which object each is" };
        var command = new Command("import", "Replace the masks of a session and what follows from them.") { folder, maps, match };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) =>
        {
            string session = parsed.GetRequiredValue(folder);
            MaskNumbers numbers = parsed.GetValue(match) ? MaskNumbers.Overlap : MaskNumbers.Ids;
            MaskImport done = MaskImporter.Import(RecordedSessions.Open(terminal, session), parsed.GetRequiredValue(maps), numbers, cancellation);
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
