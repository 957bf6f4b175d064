using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Text;
using Spectre.Console;

namespace Harvester.Cli.Commands.Faces;

/// <summary>harvester spaces: works with tables of sign faces and traffic light heads.</summary>
internal static class SpacesCommand
{
    private const string CheckExample = "  harvester spaces check data/spaces_of_interest.csv";
    private const string ListExample = "  harvester spaces list data/spaces_of_interest.csv";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("spaces", "Work with tables of sign faces and traffic light heads.")
        {
            CreateCheck(terminal),
            CreateList(terminal),
            GalleryCommand.Create(terminal),
        };
        HelpWithNotes.AddTo(command, NotesWith(CheckExample, ListExample, GalleryCommand.Example));
        return command;
    }

    /// <summary>The notes in the help of a command that reads a table.</summary>
    public static string NotesWith(params string[] examples) =>
        "data/README.md describes the columns of a table; docs/spaces.md describes how the mod measures one in the game.\n\n"
        + $"{(examples.Length > 1 ? "Examples" : "Example")}:\n"
        + string.Join('\n', examples);

    /// <summary>The argument that names a table.</summary>
    public static Argument<string> TableArgument() => new("FILE|DIR") { Description = "A table, or the folder of a survey" };

    private static ResultCommand CreateCheck(Terminal terminal)
    {
        Argument<string> file = TableArgument();
        var command = new ResultCommand("check", "List the invalid rows of a table, with reasons.") { file };
        HelpWithNotes.AddTo(command, NotesWith(CheckExample));
        command.SetAction(parsed =>
        {
            string path = FaceFile.TableOf(parsed.GetRequiredValue(file));
            FaceTableContent content = FaceFile.Read(path);
            foreach (FaceTableProblem problem in content.Problems)
            {
                terminal.Out.WriteLine($"{path}: {problem}");
            }

            int valid = content.Table.Faces.Count();
            terminal.Out.WriteLine($"{path}: {Counted.Of(valid, "valid row")}, {content.Problems.Count} invalid");
            return content.Problems.Count > 0 ? ExitCode.BadData : ExitCode.Done;
        });
        return command;
    }

    private static ResultCommand CreateList(Terminal terminal)
    {
        Argument<string> file = TableArgument();
        var command = new ResultCommand("list", "List the faces of a table: model, number, name, size and provenance.") { file };
        HelpWithNotes.AddTo(command, NotesWith(ListExample));
        command.SetAction(parsed =>
        {
            Table rows = new Table()
                .Border(TableBorder.None)
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

            string invalid = Counted.Of(content.Problems.Count, "invalid row");
            terminal.WriteError($"{invalid} not listed. For the reasons, run 'harvester spaces check'.");
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
                $"{face.BackLowerRight.X - face.FrontUpperLeft.X:0.000} x {face.FrontUpperLeft.Z - face.BackLowerRight.Z:0.000}"
            ),
            JsonName.Of(face.Facing),
            JsonName.Of(face.Provenance),
        ];
}
