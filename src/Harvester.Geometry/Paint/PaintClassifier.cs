using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Turns tracks into lines: long pieces are solid, short ones beside bare ground are dashes, and two parallel lines of one colour are a
/// double line. Tracks much fainter than the paint around them are left out.
/// </summary>
internal static class PaintClassifier
{
    /// <summary>A solid line goes on behind ground of this length that was not seen, metres: a vehicle hides as much.</summary>
    private const double MaxUnseen = 6;

    /// <summary>Fewest dashes of a dashed line.</summary>
    private const int MinDashes = 2;

    /// <summary>Largest gap between two dashes of a line, metres.</summary>
    private const double MaxDashGap = 13;

    /// <summary>
    /// Least painted part of a dashed line. Roads paint a quarter or more, 10 feet before gaps of 30; sun between the shadows of two lamps
    /// paints less.
    /// </summary>
    private const double MinPainted = 0.2;

    /// <summary>On a step that is longer than this many periods a dash is missing: half-way between one period and two.</summary>
    private const double MaxStepOverPeriod = 1.5;

    /// <summary>Paint is yellow if its blueness is below this: about 1 is white and 0.2 to 0.6 is yellow.</summary>
    private const double YellowBelow = 0.78;

    /// <summary>
    /// A line with less than this fraction of the contrast of the strongest within <see cref="Neighbourhood"/> metres is a seam, a trail or
    /// the remains of old paint.
    /// </summary>
    private const double MinContrastShare = 0.55;
    private const double Neighbourhood = 30;

    public static List<FoundLine> Lines(PaintChain chain)
    {
        List<FoundLine> lines = PaintDoubles.Joined(
            PaintTracker.Track(chain).SelectMany(track => OfTrack(track, PaintRuns.Of(track, chain)))
        );
        return [.. lines.Where(line => !IsFaint(line, lines)).OrderBy(line => line.From).ThenBy(line => line.Stripes[0].Offset)];
    }

    private static bool IsFaint(FoundLine line, List<FoundLine> lines) =>
        lines.Exists(other =>
            other.From <= line.To + Neighbourhood
            && other.To >= line.From - Neighbourhood
            && line.Contrast < MinContrastShare * other.Contrast
        );

    private static IEnumerable<FoundLine> OfTrack(PaintTrack track, List<PaintRun> runs)
    {
        for (int i = 0; i < runs.Count; )
        {
            bool isSolid = runs[i].IsSolid;
            int end = i + 1;
            while (
                end < runs.Count
                && runs[end].From - runs[end - 1].To <= (isSolid ? MaxUnseen : MaxDashGap)
                && (isSolid ? !runs[end].IsDash && !runs[end - 1].BareAfter : !runs[end].IsSolid)
            )
            {
                end++;
            }

            List<PaintRun> group = runs.GetRange(i, end - i);
            if (isSolid)
            {
                yield return Line(track, group, MarkingStyle.Solid);
            }
            else if (group.Count >= MinDashes && group.Exists(run => run.IsDash))
            {
                DashPattern? dashes = DashesOf(group);
                int whole = dashes is { } known ? UnbrokenDashes(group, known.Period) : group.Count;
                if (whole < group.Count)
                {
                    // The line ends at bare ground where a dash should be; the rest is looked at as a line of its own.
                    end = i + whole;
                    group = group.GetRange(0, whole);
                    dashes = DashesOf(group);
                }

                if (whole >= MinDashes && (dashes is not { } pattern || pattern.Length >= MinPainted * pattern.Period))
                {
                    yield return Line(track, group, MarkingStyle.Dashed) with
                    {
                        Dashes = dashes,
                    };
                }
            }

            i = end;
        }
    }

    /// <summary>Number of dashes before bare ground on which one is missing.</summary>
    private static int UnbrokenDashes(List<PaintRun> dashes, double period)
    {
        int count = 1;
        while (
            count < dashes.Count
            && !(
                dashes[count - 1].BareAfter
                && dashes[count].BareBefore
                && dashes[count].From - dashes[count - 1].From > MaxStepOverPeriod * period
            )
        )
        {
            count++;
        }

        return count;
    }

    private static FoundLine Line(PaintTrack track, List<PaintRun> runs, MarkingStyle style)
    {
        List<StripeCluster> stripes = [.. runs.SelectMany(run => track.Stripes.GetRange(run.First, run.Last - run.First + 1))];
        double Median(Func<StripeCluster, double> value) =>
            WeightedMedian.Of(stripes.ConvertAll(stripe => (value(stripe), 1 / (stripe.Sigma * stripe.Sigma))));
        MarkingColour colour = Median(stripe => stripe.Blueness) < YellowBelow ? MarkingColour.Yellow : MarkingColour.White;
        var paint = new MarkingPaint(style, colour, Median(stripe => stripe.Width));
        return new FoundLine(runs[0].From, runs[runs.Count - 1].To, stripes, paint, Median(stripe => stripe.Contrast));
    }

    /// <summary>
    /// The pattern of dashes. The length L is the median of those dashes of which both ends were seen; the middle of a dash is then L / 2
    /// from an end that was seen. The period P is the median distance of neighbouring middles; with the number n = round((m - m0) / P) of
    /// each dash, m = m0 + n · P is fitted by least squares.
    /// </summary>
    private static DashPattern? DashesOf(List<PaintRun> dashes)
    {
        List<PaintRun> whole = dashes.FindAll(dash => dash.BareBefore && dash.BareAfter);
        if (whole.Count == 0)
        {
            return null;
        }

        double length = whole.Select(dash => dash.Length).OrderBy(value => value).ElementAt((whole.Count - 1) / 2);
        List<double> middles = dashes
            .FindAll(dash => dash.IsDash)
            .ConvertAll(dash =>
                dash.BareBefore == dash.BareAfter ? (dash.From + dash.To) / 2
                : dash.BareBefore ? dash.From + (length / 2)
                : dash.To - (length / 2)
            );
        if (middles.Count < MinDashes)
        {
            return null;
        }

        List<double> steps = [.. middles.Skip(1).Zip(middles, (next, middle) => next - middle).OrderBy(step => step)];
        double period = steps[(steps.Count - 1) / 2];
        (double n, double k, double m, double kk, double km) = (0, 0, 0, 0, 0);
        foreach (double middle in middles)
        {
            double number = Math.Round((middle - middles[0]) / period);
            n++;
            k += number;
            m += middle;
            kk += number * number;
            km += number * middle;
        }

        double spread = (n * kk) - (k * k);
        double fitted = spread > 0 ? ((n * km) - (k * m)) / spread : period;
        double first = (m - (fitted * k)) / n;
        return fitted > length ? new DashPattern(length, fitted, first - (length / 2)) : null;
    }
}
