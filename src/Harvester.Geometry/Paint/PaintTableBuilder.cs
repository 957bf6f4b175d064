using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>Finds the painted lines, stop lines and crossings in what images show of the links of a network.</summary>
public static class PaintTableBuilder
{
    /// <summary>Distance of the places at which a line's offset is computed, metres: short against the bends of roads.</summary>
    private const double KnotStep = 5;

    /// <summary>A place is left out if the line through its neighbours misses it by at most this, metres.</summary>
    private const double MaxBow = 0.005;

    /// <summary>Shortest stretch of a line on a link, metres: half of a row.</summary>
    private const double MinStretch = 0.25;

    /// <summary>Builds the table.</summary>
    /// <param name="roads">The roads.</param>
    /// <param name="evidence">What the images show.</param>
    public static PaintTable Build(PaintRoads roads, PaintEvidence evidence)
    {
        RoadCurves curves = Guard.NotNull(roads, nameof(roads)).Curves;
        Guard.NotNull(evidence, nameof(evidence));
        var lines = evidence.Links.ToDictionary(link => link, _ => new List<LinePaint>());
        foreach (PaintChain chain in PaintChain.Of(roads, evidence))
        {
            List<ChainRow> starts = [.. chain.Rows.GroupBy(row => row.Link).Select(rows => rows.First())];
            foreach (FoundLine line in PaintClassifier.Lines(chain))
            {
                var fit = new OffsetFit(line.Stripes);
                double begin = 0;
                foreach (ChainRow start in starts)
                {
                    double end = begin + curves.Of(start.Link).Length;
                    lines[start.Link].AddRange(OnLink(line, fit, start, begin, end));
                    begin = end;
                }
            }
        }

        return new PaintTable(curves.Network, evidence.Links.Select(link => Seen(roads, evidence, link, lines[link])))
        {
            Marks = MarkCombiner.Of(roads.Mouths, evidence.Marks),
        };
    }

    private static LinkPaint Seen(PaintRoads roads, PaintEvidence evidence, int link, List<LinePaint> lines)
    {
        List<int> rows = [.. Enumerable.Range(0, roads.RowsOf(link)).Where(row => evidence.RowOf(link, row) is not null)];
        double half = roads.Curves.Of(link).Length / roads.RowsOf(link) / 2;
        return new LinkPaint(
            link,
            roads.StationOf(link, rows[0]) - half,
            roads.StationOf(link, rows[rows.Count - 1]) + half,
            [.. lines.OrderBy(line => line.FromStation).ThenBy(line => line.FromOffset)]
        );
    }

    /// <summary>The part of a line on one link, which lies between two stations of the chain.</summary>
    private static IEnumerable<LinePaint> OnLink(FoundLine line, OffsetFit fit, ChainRow link, double begin, double end)
    {
        double from = Math.Max(line.From, begin);
        double to = Math.Min(line.To, end);
        if (to - from < MinStretch)
        {
            yield break;
        }

        double OnLinkAt(double station) => link.IsForward ? station - begin : end - station;
        int pieces = Math.Max(1, (int)Math.Ceiling((to - from) / KnotStep));
        List<double> stations = [.. Enumerable.Range(0, pieces + 1).Select(i => from + ((to - from) * i / pieces))];
        List<(double Offset, double Sigma, int Images)> knots = stations.ConvertAll(fit.At);
        DashPattern? dashes = line.Dashes is { } pattern ? Turned(pattern, OnLinkAt, link.IsForward) : null;
        for (int i = 0; i < pieces; )
        {
            int next = i + 1;
            while (next < pieces && IsStraight(stations, knots, i, next + 1))
            {
                next++;
            }

            (int first, int last) = link.IsForward ? (i, next) : (next, i);
            yield return new LinePaint(
                Math.Max(0, OnLinkAt(stations[first])),
                OnLinkAt(stations[last]),
                link.Turned(knots[first].Offset),
                link.Turned(knots[last].Offset),
                line.Paint
            )
            {
                Dashes = dashes,
                SigmaMetres = Math.Max(knots[i].Sigma, knots[next].Sigma),
                Images = Math.Max(knots[i].Images, knots[next].Images),
            };
            i = next;
        }
    }

    private static DashPattern Turned(DashPattern pattern, Func<double, double> onLinkAt, bool isForward)
    {
        // Seen from the other end of the link, a dash begins where it ended.
        double phase = onLinkAt(isForward ? pattern.Phase : pattern.Phase + pattern.Length);
        return pattern with { Phase = phase - (pattern.Period * Math.Floor(phase / pattern.Period)) };
    }

    private static bool IsStraight(List<double> stations, List<(double Offset, double Sigma, int Images)> knots, int first, int last)
    {
        double slope = (knots[last].Offset - knots[first].Offset) / (stations[last] - stations[first]);
        for (int i = first + 1; i < last; i++)
        {
            double onLine = knots[first].Offset + (slope * (stations[i] - stations[first]));
            if (Math.Abs(knots[i].Offset - onLine) > MaxBow)
            {
                return false;
            }
        }

        return true;
    }
}
