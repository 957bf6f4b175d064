using System.Globalization;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Statistics;

/// <summary>The shares of the sources of lanes as text, for people.</summary>
public static class LaneSourceText
{
    private const string Exact = "paint of the game";

    /// <summary>Shares of frames: "measured paint 82.5 %, constant width 17.5 %"; empty without frames with known lanes.</summary>
    public static string OfFrames(LaneSources sources)
    {
        ArgumentNullException.ThrowIfNull(sources);
        return Shares([.. sources.Frames.Select(pair => (NameOf(pair.Key), pair.Value))]);
    }

    /// <summary>Shares of lane lines; empty without lines.</summary>
    public static string OfLines(LaneSources sources)
    {
        ArgumentNullException.ThrowIfNull(sources);
        return Shares([.. sources.Lines.Select(pair => (NameOf(pair.Key), pair.Value)), (Exact, sources.ExactLines)]);
    }

    /// <summary>
    /// One row for each source that occurs: its name, the number of frames with known lanes that have it, and the number of lane lines.
    /// </summary>
    public static IEnumerable<(string Name, int Frames, int Lines)> Rows(LaneSources sources)
    {
        ArgumentNullException.ThrowIfNull(sources);
        foreach (LaneWidthSource source in sources.Frames.Keys.Union(sources.Lines.Keys).Order())
        {
            yield return (NameOf(source), sources.Frames.GetValueOrDefault(source), sources.Lines.GetValueOrDefault(source));
        }

        if (sources.ExactLines > 0)
        {
            yield return (Exact, 0, sources.ExactLines);
        }
    }

    private static string Shares((string Name, int Count)[] counts)
    {
        double all = counts.Sum(pair => pair.Count);
        return string.Join(
            ", ",
            counts
                .Where(pair => pair.Count > 0)
                .Select(pair => string.Create(CultureInfo.InvariantCulture, $"{pair.Name} {100 * pair.Count / all:0.0} %"))
        );
    }

    private static string NameOf(LaneWidthSource source) =>
        source switch
        {
            LaneWidthSource.Paint => "measured paint",
            LaneWidthSource.PartlyPaint => "measured paint in part",
            LaneWidthSource.Calibrated => "edges reported by the game",
            LaneWidthSource.NarrowConstant => "constant width of narrow roads",
            _ => "constant width",
        };
}
