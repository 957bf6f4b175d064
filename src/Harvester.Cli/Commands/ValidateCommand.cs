using System.CommandLine;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Exports.Validation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Validation;

namespace Harvester.Cli.Commands;

/// <summary>harvester validate: checks a session or a dataset against its format.</summary>
internal static class ValidateCommand
{
    private const string Notes =
        "A session is checked for these:\n"
        + "  files       every line parses; images, masks and scenes exist, are complete and have the size in the label\n"
        + "  boxes       boxes lie in the image and within their amodal boxes; masks agree with boxes and labels\n"
        + "  values      fractions are 0 to 1 and consistent; distances agree with cuboids, focal lengths with fields of view; lane indicators\n"
        + "              are in range\n"
        + "  order       an id stands for one object; frame numbers and times increase\n\n"
        + "A dataset is checked for these: every label parses in its format; boxes lie in the image; ids are unique and known; images exist and\n"
        + "have their sizes; no frame is in two splits; calibrations project 3D boxes onto 2D boxes; archives are complete; the number of frames\n"
        + "is that of export.json. docs/exports has the list for each format.\n\n"
        + "Problems are printed one per line; the exit code is 1 if there are any. An unfinished last line is ignored, with a note.\n\n"
        + "Example:\n"
        + "  harvester validate out";

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        folder.Description = "Folder of a session or of an exported dataset";
        var command = new Command("validate", "Check a session or an exported dataset and list every problem.") { folder };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) =>
        {
            string session = parsed.GetRequiredValue(folder);
            if (DatasetValidator.IsDataset(session))
            {
                return Task.FromResult(ValidateDataset(terminal, session, cancellation));
            }

            if (DatasetValidator.IsUnfinished(session))
            {
                throw new DatasetFormatException(
                    $"'{session}' is an unfinished export. Run the same export command again to continue, or merge its shards.");
            }

            var reader = new SessionReader(session);
            SessionValidation validation = SessionValidator.Validate(reader, cancellation);
            foreach (SessionProblem problem in validation.Problems)
            {
                terminal.Out.WriteLine(problem);
            }

            if (RecordedSessions.NoteOf(reader) is { } note)
            {
                terminal.Out.WriteLine($"Note: {note}");
            }

            if (validation.Info is { CapturedFrames: null })
            {
                terminal.Out.WriteLine("Note: the recording was cut off before session.json was complete; the frames recorded until then are included.");
            }

            if (validation.Undetermined > 0)
            {
                terminal.Out.WriteLine(
                    $"Warning: the visibility of {validation.Undetermined} of {Counted.Of(validation.Objects, "label")} is unknown (occlusionMethod none); visibility filters leave them out.");
            }

            if (validation.UndeterminedRegions > 0)
            {
                terminal.Out.WriteLine(
                    $"Warning: the visibility of {Counted.Of(validation.UndeterminedRegions, "object")} could not be determined; they have ignore regions instead of labels.");
            }

            foreach (string open in validation.Info?.Unchecked ?? [])
            {
                terminal.Out.WriteLine($"Note: {open}");
            }

            terminal.Out.WriteLine($"{session}: {Counted.Of(validation.Frames, "frame")}, {Counted.Of(validation.Objects, "label")}, {Verdict(validation.Problems.Count)}");
            return Task.FromResult(validation.IsGood ? ExitCode.Done : ExitCode.BadData);
        });
        return command;
    }

    private static int ValidateDataset(Terminal terminal, string folder, CancellationToken cancellation)
    {
        DatasetValidation validation = DatasetValidator.Validate(folder, cancellation);
        foreach (SessionProblem problem in validation.Problems)
        {
            terminal.Out.WriteLine(problem);
        }

        terminal.Out.WriteLine($"{folder}: {validation.Format}, {Counted.Of(validation.Frames, "frame")}, {Verdict(validation.Problems.Count)}");
        return validation.Problems.Count == 0 ? ExitCode.Done : ExitCode.BadData;
    }

    private static string Verdict(int problems) => problems == 0 ? "good" : Counted.Of(problems, "problem");
}
