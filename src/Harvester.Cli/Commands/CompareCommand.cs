using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Reports.Comparison;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;
using Spectre.Console;

namespace Harvester.Cli.Commands;

/// <summary>harvester compare: compares the distributions of two datasets.</summary>
internal static class CompareCommand
{
    private const string DefaultPage = "compare.html";

    private const string Notes =
        "Compares sizes of 2D boxes, distances, truncation, occlusion, classes, observation angles, objects per frame and the\n"
        + "brightness of images. It prints the distances between the distributions and writes a page with plots and tables.\n"
        + "A session beside KITTI or nuScenes is compared in the classes of its export to that format.\n\n"
        + "Examples:\n"
        + "  harvester compare day night\n"
        + "  harvester compare out --kitti kitti/training/label_2 --out kitti.html --json kitti.json";

    public static Command Create(Terminal terminal)
    {
        var first = new Argument<string>("SESSION") { Description = "Folder of a session" };
        var second = new Argument<string?>("OTHER")
        {
            Description = "Folder of the session to compare it with",
            Arity = ArgumentArity.ZeroOrOne,
        };
        var kitti = new Option<string?>("--kitti")
        {
            Description = "Compare with KITTI: the folder label_2 or one above it",
            HelpName = "DIR",
        };
        var nuScenes = new Option<string?>("--nuscenes")
        {
            Description = "Compare with nuScenes: the folder with its tables or the one above it",
            HelpName = "DIR",
        };
        var output = new Option<string?>("--out")
        {
            Description = $"Page to write [default: {DefaultPage} in the current folder]",
            HelpName = "FILE",
        };
        var json = new Option<string?>("--json") { Description = "Also write the figures as JSON", HelpName = "FILE" };
        var command = new ResultCommand("compare", "Compare the distributions of two datasets.")
        {
            first,
            second,
            kitti,
            nuScenes,
            output,
            json,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                string?[] others = [parsed.GetValue(second), parsed.GetValue(kitti), parsed.GetValue(nuScenes)];
                if (others.Count(other => other is not null) != 1)
                {
                    throw new UsageException("Name one dataset to compare with: a second session, --kitti DIR or --nuscenes DIR.");
                }

                string page = parsed.GetValue(output) ?? DefaultPage;
                string? figures = parsed.GetValue(json);
                FileExtension.Check("--out", page, ".html", ".htm");
                if (figures is not null)
                {
                    FileExtension.Check("--json", figures, ".json");
                }

                SessionReader session = RecordedSessions.Open(terminal, parsed.GetRequiredValue(first), cancellation);
                SessionReader? other = others[0] is { } folder ? RecordedSessions.Open(terminal, folder, cancellation) : null;
                foreach (string file in new[] { page, figures }.OfType<string>())
                {
                    CheckIsNoInput(file, session, other, others[1] ?? others[2]);
                }

                IComparedDataset one =
                    other is not null ? ComparedSession.InItsTerms(session)
                    : others[1] is not null ? ComparedSession.InKittiTerms(session)
                    : ComparedSession.InNuScenesTerms(session);
                IComparedDataset two =
                    other is not null ? ComparedSession.InItsTerms(other)
                    : others[1] is { } labels ? ComparedKitti.Open(labels)
                    : ComparedNuScenes.Open(others[2]!);
                var comparison = new DatasetComparison(Read(terminal, one, cancellation), Read(terminal, two, cancellation));
                OutputFile.Write(page, stream => ComparisonPage.Write(stream, comparison));
                if (figures is not null)
                {
                    OutputFile.Write(figures, stream => ComparisonJson.Write(stream, comparison));
                }

                Print(terminal, comparison);
                terminal.Out.WriteLine(page);
                return Task.FromResult(ExitCode.Done);
            }
        );
        return command;
    }

    private static DatasetProfile Read(Terminal terminal, IComparedDataset dataset, CancellationToken cancellation)
    {
        DatasetProfile profile = new JobProgress(terminal, dataset.Length, dataset.Unit).Run(report => dataset.Read(report, cancellation));
        foreach (double brightness in ImageBrightness.Of(dataset.Images))
        {
            cancellation.ThrowIfCancellationRequested();
            profile.Of(ComparedQuantity.Brightness).Add(brightness);
        }

        return profile;
    }

    private static void Print(Terminal terminal, DatasetComparison comparison)
    {
        foreach (DatasetProfile profile in new[] { comparison.First, comparison.Second })
        {
            terminal.WriteQuoting($"{profile.Name}: {Counted.Of(profile.Frames, "frame")}, {Counted.Of(profile.Labels, "label")}");
        }

        var table = new Table { Border = TableBorder.None };
        foreach (string column in new[] { "", "median, first", "median, second", "1-Wasserstein", "Jensen-Shannon, bits" })
        {
            table.AddColumn(new TableColumn(column) { Alignment = column.Length == 0 ? Justify.Left : Justify.Right });
        }

        foreach (ComparedQuantity quantity in ComparedQuantity.All)
        {
            table.AddRow(
                quantity.Unit.Length == 0 ? quantity.Title : $"{quantity.Title}, {quantity.Unit}",
                Text(comparison.First.Of(quantity).Quantile(0.5)),
                Text(comparison.Second.Of(quantity).Quantile(0.5)),
                Text(comparison.WassersteinOf(quantity)),
                Text(comparison.JensenShannonOf(quantity))
            );
        }

        AddCounts(table, "Classes", comparison.First.Classes, comparison.Second.Classes);
        AddCounts(table, "Levels", comparison.First.Levels, comparison.Second.Levels);
        terminal.ToAnsiConsole().Write(table);
    }

    private static void AddCounts(Table table, string name, CategoryCounts first, CategoryCounts second) =>
        table.AddRow(name, "", "", "", Text(DatasetComparison.Between(first, second)?.JensenShannon));

    private static string Text(double? value) => value is { } known ? ComparisonPage.Rounded(known) : "none";

    private static void CheckIsNoInput(string file, SessionReader session, SessionReader? other, string? folder)
    {
        bool isInFolder =
            folder is not null
            && File.Exists(file)
            && InnerPath.Resolve(file).StartsWith(InnerPath.Resolve(folder) + Path.DirectorySeparatorChar, StringComparison.Ordinal);
        if (session.Holds(file) || other?.Holds(file) == true || isInFolder)
        {
            throw new UsageException($"'{file}' would replace a file of a dataset. Name another file.");
        }
    }
}
