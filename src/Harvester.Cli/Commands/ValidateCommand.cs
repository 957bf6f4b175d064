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

/// <summary>harvester validate: says whether a session is what its format promises.</summary>
internal static class ValidateCommand
{
    private const string Notes =
        "Checked are: every line can be read; images and masks are there, whole, and of the size in their label; masks show the objects of their\n"
        + "label in the boxes it says; scenes are there and can be read where the session keeps them, their roads and faces too; boxes lie in the\n"
        + "image and within their amodal boxes; fractions are 0 to 1 and follow from each other; distances agree with cuboids and focal lengths with fields\n"
        + "of view; lane indicators are in their ranges; an id means one object; frame numbers and times rise.\n"
        + "Of an exported dataset: every label of its format can be read, boxes lie in the image, ids are unique and known, images are there with\n"
        + "their sizes, splits share no frame, calibrations project boxes onto boxes, archives are whole; and there are as many frames as\n"
        + "export.json counts. docs/exports has the list.\n"
        + "All problems are listed, one a line; the exit code is 1 if there is any. A last line without a line feed is none: it is noted.\n\n"
        + "Example:\n"
        + "  harvester validate out";

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        folder.Description = "Folder of a session, as harvest writes it, or of a dataset, as export writes it";
        var command = new Command("validate", "Check a session or an exported dataset and list what is wrong with it.") { folder };
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
                    $"'{session}' is an unfinished export. Give the same export command again and it goes on; where shards were written, merge them.");
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
