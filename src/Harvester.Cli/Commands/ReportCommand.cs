using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Detections;
using Harvester.Datasets.Files;
using Harvester.Exports.Predictions;
using Harvester.Reports.Sessions;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester report: writes a page that shows a session, or an image of one of its frames.</summary>
internal static class ReportCommand
{
    private const string Notes =
        "The page shows frames with their boxes, lane lines and joints, a bird's-eye view, plots over time, filters and statistics.\n"
        + "It works offline and needs no other file: the images are embedded as JPEG, scaled down if they would exceed 5.5 MB. With\n"
        + "--link, the page shows the image files of the session. Press ? in the page for its keys.\n"
        + "With --predictions, it also shows which objects a detector finds and misses, with average precision as COCO defines it.\n\n"
        + "Examples:\n"
        + "  harvester report out\n"
        + "  harvester report out --frames 300 --out report.html\n"
        + "  harvester report out --predictions results.json --out predictions.html\n"
        + "  harvester report out --still 12 --out frame.png";

    private const int MaxFrames = 10_000;
    private const double DefaultMinScore = 0.5;
    private const double MaxScore = 1e6;

    /// <summary>The overlap of 0.75 among COCO's.</summary>
    private const int Overlap75 = 5;

    public static Command Create(Terminal terminal)
    {
        Argument<string> folder = SessionArgument.Create();
        var output = new Option<string?>("--out")
        {
            Description =
                $"File to write [default: {ReportWriter.FileName} in the session; with --still, frame-N.png in the current folder]",
            HelpName = "FILE",
        };
        Option<int> frames = ValueParsers.Integer("--frames", "N", "Maximum number of frames to show, evenly spaced", 1, MaxFrames);
        frames.DefaultValueFactory = _ => new ReportLimits().Frames;
        Option<int?> still = ValueParsers.Optional<int>(
            "--still",
            "FRAME",
            "Draw this frame with its boxes as a PNG image instead of a page",
            FrameNumber,
            "a frame number, e.g. 12"
        );
        var link = new Option<bool>("--link")
        {
            Description = "Link the images instead of embedding them; the page is small and works only next to its session",
        };
        var posts = new Option<bool>("--posts")
        {
            Description = "Draw the posts of signs and lights too, not only faces and heads; the page has a switch for them",
        };
        var predictions = new Option<string?>("--predictions")
        {
            Description = "Compare the labels with predictions: a file with COCO results, or a folder with KITTI results",
            HelpName = "FILE|DIR",
        };
        Option<double?> minScore = ValueParsers.Optional<double>(
            "--min-score",
            "N",
            "Count and draw predictions with this score or a higher one; precision and recall use all [default: 0.5]",
            text => NumberText.Read(text) is { } score && Math.Abs(score) <= MaxScore ? score : null,
            "a number, e.g. 0.5"
        );
        var command = new Command("report", "Show a session as one self-contained HTML page.")
        {
            folder,
            output,
            frames,
            still,
            posts,
            link,
            predictions,
            minScore,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                string session = parsed.GetRequiredValue(folder);
                SessionReader reader = RecordedSessions.Open(terminal, session, cancellation);
                if (parsed.GetValue(still) is { } frame)
                {
                    Option[] ofPages = [frames, link, predictions, minScore];
                    if (Array.Find(ofPages, option => parsed.GetResult(option) is { Implicit: false }) is { } idle)
                    {
                        throw new UsageException($"{idle.Name} has no effect with --still.");
                    }

                    string picture = parsed.GetValue(output) ?? $"frame-{frame}.png";
                    FileExtension.Check("--out", picture, ".png");
                    if (reader.Holds(picture))
                    {
                        throw new UsageException($"--out '{picture}' would replace a file of the session. Name another file.");
                    }

                    StillWriter.Write(reader, frame, picture, parsed.GetValue(posts));
                    terminal.Out.WriteLine(picture);
                    return Task.FromResult(ExitCode.Done);
                }

                string page = parsed.GetValue(output) ?? Path.Combine(session, ReportWriter.FileName);
                FileExtension.Check("--out", page, ".html", ".htm");
                if (reader.Holds(page))
                {
                    throw new UsageException($"--out '{page}' would replace a file of the session. Name another file.");
                }

                var limits = new ReportLimits(parsed.GetValue(frames))
                {
                    LinksImages = parsed.GetValue(link),
                    ShowsPosts = parsed.GetValue(posts),
                };
                PredictionEvaluation? evaluation = null;
                if (parsed.GetValue(predictions) is { } predicted)
                {
                    double score = parsed.GetValue(minScore) ?? DefaultMinScore;
                    evaluation = new JobProgress(terminal, reader.CountLines()).Run(progress =>
                        PredictionEvaluation.Of(reader, predicted, score, progress, cancellation)
                    );
                }
                else if (parsed.GetResult(minScore) is { Implicit: false })
                {
                    throw new UsageException("--min-score has no effect without --predictions.");
                }

                using FolderLock? held = OutputFile.Lock(page);
                int shown = new ReportWriter(reader, limits, evaluation).Write(page);
                terminal.Out.WriteLine($"{page}: {Counted.Of(shown, "frame")} shown");
                if (evaluation is not null)
                {
                    terminal.Out.WriteLine(Summary(evaluation));
                }

                return Task.FromResult(ExitCode.Done);
            }
        );
        return command;
    }

    private static string Summary(PredictionEvaluation evaluation)
    {
        OutcomeCount all = evaluation.Groups.All;
        return string.Create(CultureInfo.InvariantCulture, $"predictions: AP {Figure(tally => tally.AveragePrecision(0))}, ")
            + string.Create(CultureInfo.InvariantCulture, $"AP50 {Figure(tally => tally.AveragePrecisionAt(0))}, ")
            + string.Create(CultureInfo.InvariantCulture, $"AP75 {Figure(tally => tally.AveragePrecisionAt(Overlap75))}; ")
            + string.Create(CultureInfo.InvariantCulture, $"{all.Matches} matched, {all.Misses} missed, ")
            + Counted.Of(all.FalsePositives, "false positive")
            + string.Create(CultureInfo.InvariantCulture, $" at a score of {evaluation.MinScore} or more");

        string Figure(Func<ClassTally, double?> of) => evaluation.MeanOf(of)?.ToString("0.000", CultureInfo.InvariantCulture) ?? "none";
    }

    private static int? FrameNumber(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int frame) ? frame : null;
}
