using System.CommandLine;
using System.Globalization;
using System.Linq;
using Harvester.Cli.Faces;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Text;
using Spectre.Console;

namespace Harvester.Cli.Commands.Faces;

/// <summary>harvester spaces: works with tables of sign faces and traffic light heads.</summary>
internal static class SpacesCommand
{
    private const string Notes =
        "data/README.md describes the columns, docs/spaces.md how the mod measures a table in the game.\n\n"
        + "Examples:\n"
        + "  harvester spaces check data/spaces_of_interest.csv\n"
        + "  harvester spaces list data/spaces_of_interest.csv\n"
        + "  harvester spaces gallery data/spaces_of_interest.csv --out gallery.html";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("spaces", "Work with tables of sign faces and traffic light heads.")
        {
            CreateCheck(terminal), CreateList(terminal), GalleryCommand.Create(terminal),
        };
        HelpWithNotes.AddTo(command, Notes);
        foreach (Command each in command.Subcommands)
        {
            HelpWithNotes.AddTo(each, Notes);
        }

        return command;
    }

    private static Command CreateCheck(Terminal terminal)
    {
        Argument<string> file = FileArgument();
        var command = new Command("check", "List the invalid rows of a table, with reasons.") { file };
        command.SetAction(parsed =>
        {
            string path = FaceFile.TableOf(parsed.GetRequiredValue(file));
            FaceTableContent content = FaceFile.Read(path);
            foreach (FaceTableProblem problem in content.Problems)
            {
                terminal.Out.WriteLine($"{path}: {problem}");
            }

            int good = content.Table.Faces.Count();
            terminal.Out.WriteLine($"{path}: {Counted.Of(good, "valid row")}, {content.Problems.Count} invalid");
            return content.Problems.Count > 0 ? ExitCode.BadData : ExitCode.Done;
        });
        return command;
    }

    private static Command CreateList(Terminal terminal)
    {
        Argument<string> file = FileArgument();
        var command = new Command("list", "List the faces of a table: model, number, name, size and provenance.") { file };
        command.SetAction(parsed =>
        {
            Table rows = new Table().Border(TableBorder.None)
                .AddColumns("model", "face", "name", "mutcd", "size, m", "facing", "provenance");
            FaceTableContent content = FaceFile.Read(parsed.GetRequiredValue(file));
            foreach (ModelFace face in content.Table.Faces)
            {
                rows.AddRow([.. Cells(face).Select(cell => new Text(cell))]);
            }

            terminal.ToAnsiConsole().Write(rows);
            if (content.Problems.Count == 0)
            {
                return ExitCode.Done;
            }

            terminal.WriteError($"{Counted.Of(content.Problems.Count, "invalid row")} not listed. For the reasons, run 'harvester spaces check'.");
            return ExitCode.BadData;
        });
        return command;
    }

    private static string[] Cells(ModelFace face) =>
    [
        face.Model.Length > 0 ? face.Model : face.Hash.ToString(CultureInfo.InvariantCulture),
        face.Number.ToString(CultureInfo.InvariantCulture),
        face.Name,
        face.MutcdCode,
        string.Create(
            CultureInfo.InvariantCulture,
            $"{face.BackLowerRight.X - face.FrontUpperLeft.X:0.000} x {face.FrontUpperLeft.Z - face.BackLowerRight.Z:0.000}"),
        JsonName.Of(face.Facing),
        JsonName.Of(face.Provenance),
    ];

    private static Argument<string> FileArgument() => new("FILE|DIR") { Description = "A table, or the folder of a survey" };
}
