using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Faces;
using Harvester.Datasets.Files;
using Harvester.Reports.Faces;
using Harvester.Runs.Faults;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Faces;

/// <summary>harvester spaces gallery: writes a page that shows the faces of a table.</summary>
internal static class GalleryCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester spaces gallery data/spaces_of_interest.csv --out gallery.html";

    private const string FileName = "gallery.html";

    public static Command Create(Terminal terminal)
    {
        Argument<string> source = SpacesCommand.TableArgument();
        var output = new Option<string?>("--out")
        {
            Description = $"File to write [default: {FileName} in the folder of the survey; for a table, in the current folder]",
            HelpName = "FILE",
        };
        var command = new Command("gallery", "Show the faces of a survey or table as one self-contained HTML page.") { source, output };
        HelpWithNotes.AddTo(command, SpacesCommand.NotesWith(Example));
        command.SetAction(parsed =>
        {
            string given = parsed.GetRequiredValue(source);
            string table = FaceFile.TableOf(given);
            string folder = Path.GetDirectoryName(Path.GetFullPath(table))!;
            string page = parsed.GetValue(output) ?? (Directory.Exists(given) ? Path.Combine(folder, FileName) : FileName);
            FileExtension.Check("--out", page, ".html", ".htm");
            if (IsInput(page, table))
            {
                throw new UsageException($"--out '{page}' would replace the table or one of its pictures. Name another file.");
            }

            var gallery = new FaceGallery(FaceFile.ReadValid(table, terminal.WriteError), folder);
            OutputFile.Write(page, gallery.Write);
            terminal.Out.WriteLine($"{page}: {Counted.Of(gallery.Models, "model")} shown");
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>Whether a file is the table, or lies in a folder of its photographs.</summary>
    private static bool IsInput(string page, string table)
    {
        string folder = InnerPath.Resolve(Path.GetDirectoryName(Path.GetFullPath(table))!);
        string target = InnerPath.Resolve(page);
        string[] inputs = [InnerPath.Resolve(table), Path.Combine(folder, SurveyPhoto.TableName)];
        return inputs.Contains(target, StringComparer.OrdinalIgnoreCase)
            || Path.GetDirectoryName(target) == InnerPath.Resolve(Path.Combine(folder, SurveyPhoto.FolderName))
            || (Path.GetDirectoryName(target) == folder && Path.GetExtension(target).Equals(".png", StringComparison.OrdinalIgnoreCase));
    }
}
