using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Colours;
using Harvester.Datasets.Statistics;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>The statistics of a session in the data of a report.</summary>
internal static class ReportFigures
{
    private const int Decimals = 2;
    private const int PercentPerUnit = 100;

    /// <summary>Writes them as fields of the current object.</summary>
    public static void Write(Utf8JsonWriter json, SessionInfo info, SessionStatistics statistics)
    {
        WriteFacts(json, info, statistics);
        WriteClasses(json, statistics);
        WriteComparison(json, statistics, PublishedDataset.Kitti);
        json.WriteStartArray("histograms");
        WriteHistogram(json, "Labels by distance", statistics.Distances, "m", 1);
        WriteHistogram(json, "Labels by box height", statistics.BoxHeights, "px", 1);
        WriteHistogram(json, "Labels by box width", statistics.BoxWidths, "px", 1);
        WriteHistogram(json, "Labels by box area", statistics.BoxAreas, "px²", 1);
        WriteHistogram(json, "Labels by truncation", statistics.TruncatedFractions, "%", PercentPerUnit);
        WriteHistogram(json, "Labels by occlusion", statistics.OccludedFractions, "%", PercentPerUnit);
        json.WriteEndArray();
        WriteCounts(json, "weathers", statistics.FramesOfWeathers);
        WriteCounts(json, "hours", statistics.FramesOfHours.Select(pair => KeyValuePair.Create(Text($"{pair.Key:00}:00"), pair.Value)));
        WriteIndicators(json, statistics.Indicators);
        WriteLaneSources(json, statistics.LaneSources);
    }

    private static void WriteFacts(Utf8JsonWriter json, SessionInfo info, SessionStatistics statistics)
    {
        json.WriteStartObject("facts");
        json.WriteString("Frames", Text($"{statistics.Frames}"));
        json.WriteString("Labels", Text($"{statistics.Labels}"));
        json.WriteString("Image", $"{info.Image.Width} × {info.Image.Height} px");
        json.WriteString("Duration", Text($"{statistics.LastTimeSeconds - statistics.FirstTimeSeconds:0.0} s"));
        json.WriteString("Weather", string.Join(", ", statistics.Weathers));
        if (statistics.Events is { } events)
        {
            string counts = string.Join(", ", events.Select(each => Text($"{each.Value} {JsonName.Of(each.Key)}")));
            json.WriteString("Events", counts.Length > 0 ? counts : "none");
        }

        if (info.Seed is { } seed)
        {
            json.WriteString("Seed", Text($"{seed}"));
        }

        json.WriteEndObject();
    }

    private static void WriteClasses(Utf8JsonWriter json, SessionStatistics statistics)
    {
        json.WriteStartObject("classes");
        foreach ((ObjectClass kind, ClassStatistics figures) in statistics.Classes)
        {
            json.WriteStartObject(JsonName.Of(kind));
            json.WriteString("colour", $"#{ClassColours.Of(kind):x6}");
            json.WriteNumber("labels", figures.Labels);
            json.WriteNumber("objects", figures.Objects);
            json.WriteNumber("parts", figures.Parts);
            json.Number("nearest", figures.MinMetres, Decimals);
            json.Number("medianDistance", figures.MedianDistanceMetres, Decimals);
            json.Number("meanOcclusion", figures.MeanOccludedFraction, Decimals);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteComparison(Utf8JsonWriter json, SessionStatistics statistics, PublishedDataset published)
    {
        json.WriteStartObject("comparison");
        json.WriteString("name", published.Name);
        json.WriteStartArray("rows");
        WriteRow("Images", statistics.Frames, published.Images, 0);
        WriteRow("Images for training", null, published.TrainingImages, 0);
        WriteRow("Images for testing", null, published.TestImages, 0);
        WriteRow("Labels (no signs or traffic lights)", statistics.LabelsAsKitti, published.Labels, 0);
        WriteRow("Labels per image", statistics.LabelsAsKittiPerFrame, published.LabelsPerImage, 1);
        json.WriteEndArray();
        json.WriteEndObject();

        void WriteRow(string name, double? here, double there, int decimals)
        {
            json.WriteStartArray();
            json.WriteStringValue(name);
            json.WriteStringValue(here is { } value ? Count(value, decimals) : "");
            json.WriteStringValue(Count(there, decimals));
            json.WriteEndArray();
        }
    }

    private static void WriteHistogram(Utf8JsonWriter json, string title, Histogram histogram, string unit, double factor)
    {
        json.WriteStartObject();
        json.WriteString("title", title);
        json.WriteString("unit", unit);
        json.Numbers("counts", [.. histogram.Counts.Select(count => (double)count)], 0);
        json.Numbers("starts", [.. histogram.Starts.Select(start => start * factor)], Decimals);
        json.Number("end", histogram.End * factor, Decimals);
        json.WriteEndObject();
    }

    private static void WriteCounts(Utf8JsonWriter json, string name, IEnumerable<KeyValuePair<string, int>> counts)
    {
        json.WriteStartObject(name);
        foreach ((string key, int count) in counts)
        {
            json.WriteNumber(key, count);
        }

        json.WriteEndObject();
    }

    private static void WriteIndicators(Utf8JsonWriter json, IReadOnlyDictionary<string, IndicatorSpan> indicators)
    {
        json.WriteStartObject("indicators");
        foreach ((string name, IndicatorSpan span) in indicators)
        {
            json.WriteStartObject(name);
            json.WriteString("unit", IndicatorTable.All[IndicatorTable.IndexOf(name)].Unit);
            json.WriteNumber("frames", span.Count);
            json.Number("least", span.Min, Decimals);
            json.Number("greatest", span.Max, Decimals);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteLaneSources(Utf8JsonWriter json, LaneSources sources)
    {
        json.WriteStartArray("laneSources");
        foreach ((string name, int frames, int lines) in LaneSourceText.Rows(sources))
        {
            json.WriteStartArray();
            json.WriteStringValue(name);
            json.WriteStringValue(Count(frames, 0));
            json.WriteStringValue(Count(lines, 0));
            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    private static string Count(double value, int decimals) =>
        value.ToString("N" + decimals.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
