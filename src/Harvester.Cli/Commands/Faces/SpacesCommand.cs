using System.CommandLine;
using System.Globalization;
using System.Linq;
using Harvester.Cli.Faces;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Text;
using Spectre.Console;

namespace Harvester.Cli.Commands.Faces;

/// <summary>harvester faces: tables of the parts of models that matter.</summary>
internal static class SpacesCommand
{
    private const string Notes =
        "What the columns hold: data/README.md. How a table is measured in the game: docs/spaces.md.\n\n"
        + "Examples:\n"
        + "  harvester spaces check data/spaces_of_interest.csv\n"
        + "  harvester spaces list data/spaces_of_interest.csv\n"
        + "  harvester spaces gallery data/spaces_of_interest.csv --out gallery.html";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("spaces", "Check, list and show tables of faces of signs and heads of traffic lights.")
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
        var command = new Command("check", "Say which rows of a table are refused, and why.") { file };
        command.SetAction(parsed =>
        {
            string path = FaceFile.TableOf(parsed.GetRequiredValue(file));
            FaceTableContent content = FaceFile.Read(path);
            foreach (FaceTableProblem problem in content.Problems)
            {
                terminal.Out.WriteLine($"{path}: {problem}");
            }

            int good = content.Table.Faces.Count();
            terminal.Out.WriteLine($"{path}: {Counted.Of(good, "row")} good, {content.Problems.Count} refused");
            return content.Problems.Count > 0 ? ExitCode.BadData : ExitCode.Done;
        });
        return command;
    }

    private static Command CreateList(Terminal terminal)
    {
        Argument<string> file = FileArgument();
        var command = new Command("list", "List the spaces of a table: model, face, name, size and how it was come by.") { file };
        command.SetAction(parsed =>
        {
            Table rows = new Table().Border(TableBorder.None).AddColumns("model", "face", "name", "mutcd", "size, m", "facing", "provenance");
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

            terminal.WriteError($"Refused and not listed: {content.Problems.Count} of the rows. See 'harvester spaces check'.");
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

    private static Argument<string> FileArgument() => new("FILE|DIR") { Description = "The table, or a survey's folder" };
}
