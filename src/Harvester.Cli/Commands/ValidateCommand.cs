using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Validation;
using Harvester.Exports.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester validate: checks a session or a dataset against its format.</summary>
internal static class ValidateCommand
{
    private const string Notes =
        "Checks of a session:\n"
        + "  files       every line parses; images, masks and scenes exist, are complete and have the size in the label\n"
        + "  boxes       boxes lie in the image and within their amodal boxes; masks agree with boxes and labels\n"
        + "  values      fractions are 0 to 1 and consistent; distances agree with cuboids, focal lengths with fields of view; lane\n"
        + "              indicators are in range\n"
        + "  order       an id stands for one object; frame numbers and times increase\n"
        + "  manifest    every picture decodes, and every file and label line has the SHA-256 in manifest.jsonl\n\n"
        + "Checks of a dataset, as far as its format has these things (docs/exports has the list for each format):\n"
        + "  files       every label parses; images exist and have the size in the label; archives are complete\n"
        + "  boxes       boxes lie in the image; calibrations project 3D boxes onto 2D boxes\n"
        + "  order       ids are unique and known; no frame is in two splits; the number of frames is that of export.json\n"
        + "  manifest    every file has the SHA-256 in manifest.jsonl, and no other file is among them\n\n"
        + "--schema also compares session.json and every label line with the JSON Schemas in docs/schema, and reports fields\n"
        + "that these do not have. It takes many times as long.\n\n"
        + "Problems are printed one per line; the exit code is 1 if there are any. An unfinished last line is ignored, with a note.\n\n"
        + "Example:\n"
        + "  harvester validate out";

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        folder.Description = "Folder of a session or of an exported dataset";
        var quick = new Option<bool>("--quick") { Description = "Compare pictures with the manifest only, and do not decode them" };
        var schema = new Option<bool>("--schema") { Description = "Also compare a session with the published JSON Schemas" };
        var command = new ResultCommand("validate", "Check a session or an exported dataset and list every problem.")
        {
            folder,
            quick,
            schema,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                string session = parsed.GetRequiredValue(folder);
                if (DatasetValidator.IsDataset(session))
                {
                    return Task.FromResult(ValidateDataset(terminal, session, cancellation));
                }

                if (DatasetValidator.IsUnfinished(session))
                {
                    throw new DatasetFormatException(
                        $"'{session}' is an unfinished export. Run the same export command again to continue, or merge its shards."
                    );
                }

                var reader = new SessionReader(session);
                SessionValidation validation = SessionValidator.Validate(reader, parsed.GetValue(quick), cancellation);
                IReadOnlyList<SessionProblem> differences = parsed.GetValue(schema) ? SchemaValidator.Problems(reader, cancellation) : [];
                foreach (SessionProblem problem in validation.Problems.Concat(differences))
                {
                    terminal.WriteQuoting(problem.ToString());
                }

                if (RecordedSessions.NoteOf(reader) is { } note)
                {
                    terminal.Out.WriteLine($"Note: {note}");
                }

                if (validation is { HasManifest: false, Frames: > 0, Info: not { HasManifest: true } })
                {
                    terminal.Out.WriteLine(
                        $"Note: the session has no {Manifest.FileName}, so damage that leaves its files readable is not found."
                    );
                }

                if (validation.Info is { CapturedFrames: null })
                {
                    terminal.Out.WriteLine(
                        "Note: the recording was cut off before session.json was complete; the frames recorded until then are included."
                    );
                }
                else if (File.Exists(Path.Combine(session, UnfinishedMark.FileName)))
                {
                    terminal.Out.WriteLine(
                        $"Note: the session has the file {UnfinishedMark.FileName}: it is being written, or the command was stopped."
                    );
                }

                if (validation.Undetermined > 0)
                {
                    string labels = Counted.Of(validation.Objects, "label");
                    terminal.Out.WriteLine(
                        $"Warning: the visibility of {validation.Undetermined} of {labels} is unknown "
                            + "(occlusionMethod none); filters by visibility leave them out."
                    );
                }

                if (validation.UndeterminedRegions > 0)
                {
                    string objects = Counted.Of(validation.UndeterminedRegions, "object");
                    terminal.Out.WriteLine(
                        $"Warning: the visibility of {objects} could not be determined; they have ignore regions instead of labels."
                    );
                }

                foreach (string open in validation.Info?.Unchecked ?? [])
                {
                    terminal.WriteQuoting($"Note: {open}");
                }

                string counts = $"{Counted.Of(validation.Frames, "frame")}, {Counted.Of(validation.Objects, "label")}";
                terminal.Out.WriteLine($"{session}: {counts}, {Verdict(validation.Problems.Count + differences.Count)}");
                return Task.FromResult(validation.IsGood && differences.Count == 0 ? ExitCode.Done : ExitCode.BadData);
            }
        );
        return command;
    }

    private static int ValidateDataset(Terminal terminal, string folder, CancellationToken cancellation)
    {
        DatasetValidation validation = DatasetValidator.Validate(folder, cancellation);
        foreach (SessionProblem problem in validation.Problems)
        {
            terminal.WriteQuoting(problem.ToString());
        }

        if (!validation.HasManifest && validation.Problems.All(problem => problem.File != Manifest.FileName))
        {
            terminal.Out.WriteLine($"Note: the dataset has no {Manifest.FileName}, so damage that leaves its files readable is not found.");
        }

        if (validation.OtherFiles.Count > 0)
        {
            string others = Counted.Of(validation.OtherFiles.Count, "file");
            terminal.WriteQuoting(
                $"Note: {others} in the folder not listed in {Manifest.FileName}, e.g. '{validation.OtherFiles[0]}'; "
                    + "readers of the format ignore such files."
            );
        }

        string frames = Counted.Of(validation.Frames, "frame");
        terminal.Out.WriteLine($"{folder}: {validation.Format}, {frames}, {Verdict(validation.Problems.Count)}");
        return validation.Problems.Count == 0 ? ExitCode.Done : ExitCode.BadData;
    }

    private static string Verdict(int problems) => problems == 0 ? "no problems" : Counted.Of(problems, "problem");
}
