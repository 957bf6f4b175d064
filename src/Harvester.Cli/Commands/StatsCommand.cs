using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester stats: figures of one or more sessions, beside those of a published dataset.</summary>
internal static class StatsCommand
{
    private const string Notes =
        "The figures are of all sessions together: counts by class, distances, heights, widths and areas of boxes in the image,\n"
        + "truncation (the share of an object outside the image), occlusion (the share of its silhouette in the image that is hidden), weather,\n"
        + "hours, and between what values the lane indicators were. An object has a label in each frame that shows it. Bins\n"
        + "hold their lower end. Medians are to 1/4096 of their value.\n\n"
        + "Example:\n"
        + "  harvester stats day night";

    public static Command Create(Terminal terminal)
    {
        var sessions = new Argument<string[]>("SESSION") { Description = "Folders of sessions, as harvest writes them", Arity = ArgumentArity.OneOrMore };
        var command = new Command("stats", "Count what sessions hold.") { sessions };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            SessionReader[] readers = [.. parsed.GetRequiredValue(sessions).Select(folder => RecordedSessions.Open(terminal, folder))];
            foreach (string line in Lines(SessionStatistics.Of(readers.Select(reader => reader.ReadLabels()))))
            {
                terminal.Out.WriteLine(line);
            }

            return ExitCode.Done;
        });
        return command;
    }

    private static IEnumerable<string> Lines(SessionStatistics statistics)
    {
        PublishedDataset kitti = PublishedDataset.Kitti;
        yield return Text($"{Counted.Of(statistics.Frames, "frame")}, {Counted.Of(statistics.Labels, "label")}, {statistics.LabelsPerFrame:0.0} a frame");
        yield return Text($"for comparison, {kitti.Name}: {kitti.TrainingImages} images for training, {kitti.TestImages} for testing, {kitti.Labels} labelled objects, {kitti.LabelsPerImage:0.0} an image; it has neither signs nor lights, without which there are {Counted.Of(statistics.LabelsAsKitti, "label")} here, {statistics.LabelsAsKittiPerFrame:0.0} a frame");
        foreach ((ObjectClass kind, ClassStatistics figures) in statistics.Classes)
        {
            yield return Text($"class {JsonName.Of(kind)}: {Counted.Of(figures.Labels, "label")}, {Counted.Of(figures.Objects, "object")}{PartsOf(figures)}, nearest {figures.MinMetres:0.0} m, median distance {figures.MedianDistanceMetres:0.0} m");
        }

        yield return Bins("distance, m", statistics.Distances);
        yield return Bins("height of box2d, px", statistics.BoxHeights);
        yield return Bins("width of box2d, px", statistics.BoxWidths);
        yield return Bins("area of box2d, px²", statistics.BoxAreas);
        yield return Bins("truncated fraction", statistics.TruncatedFractions);
        yield return Bins("occluded fraction", statistics.OccludedFractions);
        yield return Listed("weather", statistics.FramesOfWeathers.Select(pair => Text($"{pair.Key} {pair.Value}")));
        yield return Listed("hour", statistics.FramesOfHours.Select(pair => Text($"{pair.Key:00} {pair.Value}")));
        foreach ((string name, IndicatorSpan span) in statistics.Indicators)
        {
            yield return Text($"indicator {name}: {Counted.Of(span.Count, "frame")}, {span.Least:0.00} to {span.Greatest:0.00}");
        }
    }

    private static string PartsOf(ClassStatistics figures) => figures.Parts == 0 ? "" : Text($" ({figures.Parts} of them faces or heads)");

    /// <summary>The bins that hold something.</summary>
    private static string Bins(string name, Histogram histogram) => Listed(
        name, histogram.Counts.Select((count, bin) => (count, bin)).Where(pair => pair.count > 0).Select(pair => $"{RangeOf(histogram, pair.bin)} {pair.count}"));

    private static string RangeOf(Histogram histogram, int bin) => (bin + 1 < histogram.Starts.Count ? histogram.Starts[bin + 1] : histogram.End) is { } end
        ? Text($"{histogram.Starts[bin]:0.##}-{end:0.##}:")
        : Text($"{histogram.Starts[bin]:0.##} or more:");

    private static string Listed(string name, IEnumerable<string> items) => $"{name}: {(items.Any() ? string.Join(", ", items) : "none")}";

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
