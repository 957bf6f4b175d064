using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Exports.Pairs;
using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester pairs: exports all pictures of moments, grouped by moment.</summary>
internal sealed class PairsCommand
{
    private const string Notes =
        "A group has all pictures of one moment: the image of the frame and those of harvester harvest --pair-weathers, --pair-hours and\n"
        + "--pair-without. They share the labels. csv writes the pictures to images/GROUP and the tables index.csv and objects.csv;\n"
        + "webdataset writes archives with one sample for each group, and the same tables. docs/pairs.md describes both.\n"
        + "Of a folder of harvester counterfactual, a group has the same frame of all runs (docs/counterfactuals.md).\n"
        + "With --resume, the command continues after a stop: what it has written whole stays.\n\n"
        + "Examples:\n"
        + "  harvester pairs out --out trials --format csv\n"
        + "  harvester pairs out --out trials --format webdataset";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write to, new or empty",
            HelpName = "DIR",
            Required = true,
        };
    private Option<PairFormat> Format { get; } = ValueParsers.Choice<PairFormat>("--format", "csv or webdataset [default: csv]");
    private Option<ImageTransfer> Images { get; } = TransferOption.Create("images");
    private Option<bool> Resume { get; } = ResumeOption.Create();
    private Option<SyncMode> Sync { get; } = SyncOption.Create();

    public static Command Create(Terminal terminal) => new PairsCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        Argument<string> session = SessionArgument.Create();
        var command = new Command("pairs", "Export the pictures of moments in several weathers, at several hours and without objects.")
        {
            session,
            Out,
            Format,
            Images,
            Sync,
            Resume,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(session), parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, string folder, ParseResult parsed, CancellationToken cancellation)
    {
        if (ChangeSet.IsIn(folder))
        {
            return RunSet(terminal, folder, parsed, cancellation);
        }

        string target = parsed.GetRequiredValue(Out);
        var session = new SessionReader(folder, cancellation);
        if (session.HasUnfinishedLine)
        {
            terminal.WriteError($"'{folder}' ends in an unfinished line, which is ignored.");
        }

        bool resumes = parsed.GetValue(Resume);
        var exporter = new PairExporter(session, parsed.GetValue(Format), parsed.GetValue(Images), parsed.GetValue(Sync))
        {
            Resumes = resumes,
        };
        if (resumes && FinishedResult.Of(target, () => exporter.Finished(target)) is { } finished)
        {
            terminal.Out.WriteLine(
                $"{target}: {Counted.Of(finished.Groups, "group")}, "
                    + $"{Counted.Of(finished.Images, "picture")}; the export is finished already."
            );
            return ExitCode.Done;
        }

        using var output = new PairsOutput(target, CommandText.Of(parsed), resumes);
        output.Begin();
        PairExport done = new(0, 0, 0);
        try
        {
            new JobProgress(terminal, session.CountLines()).Run(report =>
            {
                done = exporter.Run(target, report, cancellation);
                return done.Groups;
            });
        }
        catch (OperationCanceledException)
        {
            output.Keep();
            throw;
        }

        output.Complete();
        string missing = done.Missing > 0 ? $"; {done.Missing} are missing because the harvest dropped them" : "";
        terminal.Out.WriteLine($"{target}: {Counted.Of(done.Groups, "group")}, {Counted.Of(done.Images, "picture")}{missing}");
        return ExitCode.Done;
    }

    private int RunSet(Terminal terminal, string folder, ParseResult parsed, CancellationToken cancellation)
    {
        if (parsed.GetValue(Format) != PairFormat.Csv)
        {
            throw new UsageException("Counterfactuals are exported with --format csv only.");
        }

        string target = parsed.GetRequiredValue(Out);
        var exporter = new ChangeSetExporter(folder, parsed.GetValue(Images), cancellation);
        using var output = new PairsOutput(target, CommandText.Of(parsed), resumes: false);
        output.Begin();
        PairExport done = new(0, 0, 0);
        new JobProgress(terminal, exporter.Frames).Run(report =>
        {
            done = exporter.Run(target, report);
            return done.Groups;
        });
        output.Complete();
        string missing = done.Missing > 0 ? $"; {done.Missing} are missing because a run has not these frames" : "";
        terminal.Out.WriteLine($"{target}: {Counted.Of(done.Groups, "group")}, {Counted.Of(done.Images, "picture")}{missing}");
        return ExitCode.Done;
    }
}
