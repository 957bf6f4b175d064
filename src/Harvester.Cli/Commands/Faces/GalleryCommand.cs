using System.CommandLine;
using System.IO;
using Harvester.Cli.Faces;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Commands.Faces;

/// <summary>harvester spaces gallery: one page that shows the faces of a table.</summary>
internal static class GalleryCommand
{
    private const string FileName = "gallery.html";

    public static Command Create(Terminal terminal)
    {
        var source = new Argument<string>("DIR|FILE") { Description = "The folder of a survey, or a table" };
        var output = new Option<string?>("--out") { Description = $"File to write [default: {FileName} in the folder of the survey; for a table, in the current folder]", HelpName = "FILE" };
        var command = new Command("gallery", "Show the faces of a survey or table as one self-contained HTML page.") { source, output };
        command.SetAction(parsed =>
        {
            string given = parsed.GetRequiredValue(source);
            string table = FaceFile.TableOf(given);
            string folder = Path.GetDirectoryName(Path.GetFullPath(table))!;
            string page = parsed.GetValue(output) ?? (Directory.Exists(given) ? Path.Combine(folder, FileName) : FileName);
            var gallery = new FaceGallery(FaceFile.ReadGood(table, terminal.WriteError), folder);
            AtomicFile.Write(page, gallery.Write);
            terminal.Out.WriteLine($"{page}: {Counted.Of(gallery.Models, "model")} shown");
            return ExitCode.Done;
        });
        return command;
    }
}
