using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads paint: measures the lines painted on roads in the images of sessions.</summary>
internal static class RoadsPaintCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads paint session --out paint.csv";

    private const string Notes =
        "Sessions of the same roads are combined: the more images show a line, the surer it is. The sessions are not changed.\n"
        + "docs/paint.md describes the method, the table and the limits.\n\n"
        + "Examples:\n"
        + Example
        + "\n"
        + "  harvester roads paint monday tuesday --roads roads.csv.gz --out paint.csv\n"
        + "  harvester roads paint above --out paint.csv";

    public static Command Create(Terminal terminal)
    {
        var sessions = new Argument<string[]>("SESSION") { Description = "Folders of harvested sessions", Arity = ArgumentArity.OneOrMore };
        var roads = new Option<FileInfo?>("--roads")
        {
            Description = "Road network, a file or folder [default: the roads recorded in the first session]",
            HelpName = "FILE",
        };
        Option<string> output = RoadSourceArgument.Output("Table to write, CSV");
        var command = new Command("paint", "Measure the lines, stop lines, crossings and arrows painted on roads in images.")
        {
            sessions,
            roads,
            output,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(
                    Run(
                        terminal,
                        parsed.GetRequiredValue(sessions),
                        parsed.GetValue(roads)?.FullName,
                        parsed.GetRequiredValue(output),
                        cancellation
                    )
                )
        );
        return command;
    }

    private static int Run(Terminal terminal, string[] folders, string? roads, string file, CancellationToken cancellation)
    {
        List<SessionReader> sessions = [.. folders.Select(folder => RecordedSessions.Open(terminal, folder, cancellation))];
        RoadNetwork network = roads is not null
            ? RoadImporter.Import(roads).Network
            : PaintSurvey.RoadsOf(sessions[0])
                ?? throw new DatasetFormatException($"'{sessions[0].Folder}' has no recorded roads. Name a road network with --roads.");
        if (sessions.Find(session => session.Holds(file)) is { } holder)
        {
            throw new UsageException($"--out {file} would replace a file of '{holder.Folder}'. Name another file.");
        }

        var survey = new PaintSurvey(network);
        PaintTable table = new JobProgress(terminal, sessions.Sum(session => session.CountLines()), "images").Run(report =>
        {
            sessions.ForEach(session => survey.Add(session, report));
            return survey.Measure();
        });
        PaintFile.Write(table, file);
        int lines = table.Links.Sum(link => link.Lines.Count);
        double metres = table.Links.Sum(link => link.Lines.Sum(line => line.ToStation - line.FromStation));
        string found = string.Create(CultureInfo.InvariantCulture, $"{Counted.Of(lines, "piece")} of lines, {metres / 1000:0.0} km");
        string stopLines = Counted.Of(table.Marks.Count(static mark => mark.Mark.Kind == MarkKind.StopLine), "stop line");
        string crossings = Counted.Of(table.Marks.Count(static mark => mark.Mark.Kind == MarkKind.Crossing), "crossing");
        string arrows = Counted.Of(table.Marks.Count(static mark => mark.Mark.Kind >= MarkKind.ArrowStraight), "arrow");
        terminal.Out.WriteLine($"{file}: {found}, on {Counted.Of(table.Links.Count, "link")}; {stopLines}, {crossings}, {arrows}");
        return ExitCode.Done;
    }
}
