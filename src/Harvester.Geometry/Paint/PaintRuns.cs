namespace Harvester.Geometry.Paint;

/// <summary>Divides a track into unbroken pieces.</summary>
internal static class PaintRuns
{
    /// <summary>
    /// Ground without paint, or that was not seen, does not break a line up to this length, metres: wear and dirt; the gaps of dashes are
    /// 2 m and more.
    /// </summary>
    private const double MaxWorn = 1.3;

    /// <summary>Pieces shorter than this are reflectors, specks and letters, metres.</summary>
    private const double MinLength = 1.2;

    /// <summary>Least fraction of the seen rows of a piece that show paint.</summary>
    private const double MinDensity = 0.6;

    private const double HalfRow = PaintRow.Length / 2;

    public static List<PaintRun> Of(PaintTrack track, PaintChain chain)
    {
        var runs = new List<PaintRun>();
        List<StripeCluster> stripes = track.Stripes;
        int first = 0;
        (bool bareBefore, _, _) = Beyond(chain, stripes[0], -1);
        for (int i = 0; i < stripes.Count; i++)
        {
            bool isLast = i == stripes.Count - 1;
            (bool isBare, double unseen, double bare) = isLast ? Beyond(chain, stripes[i], 1) : Between(chain, stripes[i], stripes[i + 1]);
            if (!isLast && bare + unseen <= MaxWorn)
            {
                continue;
            }

            var run = new PaintRun(stripes[first].Station - HalfRow, stripes[i].Station + HalfRow, bareBefore, isBare, first, i);
            if (run.Length >= MinLength && i - first + 1 >= MinDensity * SeenRows(chain, stripes, first, i))
            {
                runs.Add(run);
            }

            first = i + 1;
            bareBefore = isBare;
        }

        return runs;
    }

    /// <summary>What lies between two stripes: whether some of it is bare, and the lengths that were not seen and that are bare.</summary>
    private static (bool IsBare, double Unseen, double Bare) Between(PaintChain chain, StripeCluster from, StripeCluster to)
    {
        double unseen = 0;
        double bare = 0;
        for (int row = from.Row + 1; row < to.Row; row++)
        {
            double part = (chain.Rows[row].Station - from.Station) / (to.Station - from.Station);
            bool isSeen = StripeClusters.SeenWeight(chain.Rows[row], from.Offset + (part * (to.Offset - from.Offset))) > 0;
            unseen += isSeen ? 0 : PaintRow.Length;
            bare += isSeen ? PaintRow.Length : 0;
        }

        return (bare > MaxWorn, unseen, bare);
    }

    /// <summary>What lies beyond the end of a track, up to the length that ends a line.</summary>
    private static (bool IsBare, double Unseen, double Bare) Beyond(PaintChain chain, StripeCluster end, int step)
    {
        double bare = 0;
        for (int row = end.Row + step; row >= 0 && row < chain.Rows.Count && bare <= MaxWorn; row += step)
        {
            if (StripeClusters.SeenWeight(chain.Rows[row], end.Offset) <= 0)
            {
                break;
            }

            bare += PaintRow.Length;
        }

        return (bare > MaxWorn, 0, bare);
    }

    private static int SeenRows(PaintChain chain, List<StripeCluster> stripes, int first, int last)
    {
        int seen = 0;
        for (int row = stripes[first].Row; row <= stripes[last].Row; row++)
        {
            seen += StripeClusters.SeenWeight(chain.Rows[row], stripes[first].Offset) > 0 ? 1 : 0;
        }

        return seen;
    }
}
