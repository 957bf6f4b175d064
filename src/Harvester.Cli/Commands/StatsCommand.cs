using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Statistics;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Events;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester stats: prints statistics of one or more sessions, next to those of a published dataset.</summary>
internal static class StatsCommand
{
    private const string Notes =
        "The statistics cover all sessions together. Histograms show the number of labels in each bin; a bin includes its lower end.\n"
        + "  truncation   fraction of an object outside the image\n"
        + "  occlusion    fraction of its silhouette within the image that is hidden\n"
        + "  indicators   minimum and maximum; active indicators as a share of the frames whose lanes are known and, for the lanes\n"
        + "               beside the car's (LL, RR), whose road has two lanes or more in its direction\n"
        + "An object has one label in each frame in which it appears. Medians are accurate to 1/4096 of their value.\n\n"
        + "Example:\n"
        + "  harvester stats day night";

    public static Command Create(Terminal terminal)
    {
        var sessions = new Argument<string[]>("SESSION") { Description = "Folders of recorded sessions", Arity = ArgumentArity.OneOrMore };
        var command = new ResultCommand("stats", "Show statistics of sessions.") { sessions };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                SessionReader[] readers =
                [
                    .. parsed.GetRequiredValue(sessions).Select(folder => RecordedSessions.Open(terminal, folder, cancellation)),
                ];
                var events = new EventStatistics();
                foreach (string line in Lines(SessionStatistics.Of(readers.Select(events.Observed))).Concat(Lines(events)))
                {
                    terminal.Out.WriteLine(line);
                }

                return Task.FromResult(ExitCode.Done);
            }
        );
        return command;
    }

    private static IEnumerable<string> Lines(EventStatistics events) =>
        events.AreRecorded
            ? Enum.GetValues<EventKind>()
                .Select(kind => (Kind: kind, Count: events.Counts.GetValueOrDefault(kind)))
                .Select(each =>
                    Text($"event {JsonName.Of(each.Kind)}: {each.Count}")
                    + (events.Kilometres > 0 ? Text($", {each.Count / events.Kilometres:0.00} per km of {events.Kilometres:0.00} km") : "")
                )
            : [];

    private static IEnumerable<string> Lines(SessionStatistics statistics)
    {
        PublishedDataset kitti = PublishedDataset.Kitti;
        string labels = Counted.Of(statistics.Labels, "label");
        string labelsAsKitti = Counted.Of(statistics.LabelsAsKitti, "label");
        yield return Text($"{Counted.Of(statistics.Frames, "frame")}, {labels}, {statistics.LabelsPerFrame:0.0} labels per frame");
        yield return Text($"{kitti.Name}, for comparison: {kitti.TrainingImages} training and {kitti.TestImages} test images, ")
            + Text($"{kitti.Labels} labels, {kitti.LabelsPerImage:0.0} labels per image");
        yield return Text($"without signs, traffic lights and riders, which KITTI does not label by themselves: {labelsAsKitti}, ")
            + Text($"{statistics.LabelsAsKittiPerFrame:0.0} labels per frame");
        foreach ((ObjectClass kind, ClassStatistics figures) in statistics.Classes)
        {
            string objects = Counted.Of(figures.Objects, "object") + PartsOf(figures);
            yield return Text($"class {JsonName.Of(kind)}: {Counted.Of(figures.Labels, "label")}, {objects}, ")
                + Text($"nearest {figures.MinMetres:0.0} m, median distance {figures.MedianDistanceMetres:0.0} m");
        }

        yield return Bins("distance, m", statistics.Distances);
        yield return Bins("2D box height, px", statistics.BoxHeights);
        yield return Bins("2D box width, px", statistics.BoxWidths);
        yield return Bins("2D box area, px²", statistics.BoxAreas);
        yield return Bins("truncation", statistics.TruncatedFractions);
        yield return Bins("occlusion", statistics.OccludedFractions);
        yield return Listed("weather", statistics.FramesOfWeathers.Select(pair => Text($"{pair.Key}: {pair.Value}")));
        yield return Listed("hour of day", statistics.FramesOfHours.Select(pair => Text($"{pair.Key:00}: {pair.Value}")));
        foreach ((string name, IndicatorSpan span) in statistics.Indicators)
        {
            string unit = IndicatorTable.All[IndicatorTable.IndexOf(name)].Unit;
            yield return Text($"indicator {name}, {unit}: {Counted.Of(span.Count, "frame")}, {span.Min:0.00} to {span.Max:0.00}");
        }

        foreach (string line in Variety(statistics))
        {
            yield return line;
        }
    }

    /// <summary>What a session offers to a network that learns from it.</summary>
    private static IEnumerable<string> Variety(SessionStatistics statistics)
    {
        LaneVariety lanes = statistics.Lanes;
        if (lanes.Frames > 0)
        {
            yield return Listed(
                "active indicators, of frames whose road has them",
                IndicatorTable.All.Select(
                    (indicator, i) => Text($"{indicator.Name}: {100 * lanes.ActiveFraction(i):0.0} % of {lanes.FramesWith(i)}")
                )
            );
            yield return $"lane geometry, of frames with known lanes: {LaneSourceText.OfFrames(statistics.LaneSources)}";
            yield return Listed("lane lines", new[] { LaneSourceText.OfLines(statistics.LaneSources) }.Where(text => text.Length > 0));
            yield return Text($"lateral offset, m: standard deviation {lanes.OffsetDeviationMetres:0.00}, ")
                + Text($"{lanes.MinOffsetMetres:0.00} to {lanes.MaxOffsetMetres:0.00}");
        }

        if (statistics.Labels > 0)
        {
            yield return Text($"labels under {SessionStatistics.SmallPixels} px high: {statistics.SmallLabels} of {statistics.Labels}, ")
                + Text($"{100.0 * statistics.SmallLabels / statistics.Labels:0.0} %");
        }

        yield return Listed("classes without labels", statistics.MissingClasses.Select(JsonName.Of));
    }

    private static string PartsOf(ClassStatistics figures) =>
        figures.Parts == 0 ? "" : Text($" (of which faces or heads: {figures.Parts})");

    /// <summary>The bins that are not empty.</summary>
    private static string Bins(string name, Histogram histogram) =>
        Listed(
            name,
            histogram
                .Counts.Select((count, bin) => (count, bin))
                .Where(pair => pair.count > 0)
                .Select(pair => $"{RangeOf(histogram, pair.bin)} {pair.count}")
        );

    private static string RangeOf(Histogram histogram, int bin) =>
        (bin + 1 < histogram.Starts.Count ? histogram.Starts[bin + 1] : histogram.End) is { } end
            ? Text($"{histogram.Starts[bin]:0.##}-{end:0.##}:")
            : Text($"{histogram.Starts[bin]:0.##} or more:");

    private static string Listed(string name, IEnumerable<string> items) => $"{name}: {(items.Any() ? string.Join(", ", items) : "none")}";

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
