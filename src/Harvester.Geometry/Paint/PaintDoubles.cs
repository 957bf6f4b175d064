using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Joins parallel lines of one colour to double lines. Each stripe of a double line may have been found in several pieces.
/// </summary>
internal static class PaintDoubles
{
    /// <summary>Distance of the middles of a double line's stripes, metres.</summary>
    private const double MinDouble = 0.15;
    private const double MaxDouble = 0.6;

    /// <summary>Least part of the shorter line of a pair that lies beside the other.</summary>
    private const double MinOverlap = 0.6;

    /// <summary>The lines, with pairs replaced by double lines.</summary>
    public static List<FoundLine> Joined(IEnumerable<FoundLine> lines)
    {
        var joined = new List<FoundLine>();
        List<FoundLine> open = [.. lines.OrderBy(line => line.From)];
        while (open.Count > 0)
        {
            FoundLine first = open[0];
            open.RemoveAt(0);
            FoundLine? partner = open.Find(other => Distance(first, other) is not null);
            if (partner is null)
            {
                joined.Add(first);
                continue;
            }

            bool isFirstLeft = Distance(first, partner) > 0;
            List<FoundLine> left = [isFirstLeft ? first : partner];
            List<FoundLine> right = [isFirstLeft ? partner : first];
            open.Remove(partner);
            bool hasMore = true;
            while (hasMore)
            {
                hasMore =
                    Take(open, right, line => left.Exists(other => Distance(other, line) > 0))
                    || Take(open, left, line => right.Exists(other => Distance(other, line) < 0));
            }

            joined.Add(Double(left, right));
        }

        return joined;
    }

    /// <summary>Takes a piece of a stripe that belongs to it and lies beside no other piece of it.</summary>
    private static bool Take(List<FoundLine> from, List<FoundLine> to, Predicate<FoundLine> belongs)
    {
        int found = from.FindIndex(line => belongs(line) && to.TrueForAll(piece => piece.To <= line.From || piece.From >= line.To));
        if (found < 0)
        {
            return false;
        }

        to.Add(from[found]);
        from.RemoveAt(found);
        return true;
    }

    /// <summary>
    /// Median distance from a line to another in the rows that both have, metres, positive if the other is to the right; null if the two
    /// are not the stripes of a double line.
    /// </summary>
    private static double? Distance(FoundLine line, FoundLine other)
    {
        double overlap = Math.Min(line.To, other.To) - Math.Max(line.From, other.From);
        if (line.Paint.Colour != other.Paint.Colour || overlap < MinOverlap * Math.Min(line.Length, other.Length))
        {
            return null;
        }

        double? distance = Median(Offsets([line]), Offsets([other]));
        return distance is { } apart && Math.Abs(apart) is >= MinDouble and <= MaxDouble ? distance : null;
    }

    private static double? Median(Dictionary<int, StripeCluster> from, Dictionary<int, StripeCluster> to)
    {
        double[] distances =
        [
            .. from.Where(stripe => to.ContainsKey(stripe.Key))
                .Select(stripe => to[stripe.Key].Offset - stripe.Value.Offset)
                .OrderBy(distance => distance),
        ];
        return distances.Length > 0 ? distances[distances.Length / 2] : null;
    }

    private static Dictionary<int, StripeCluster> Offsets(List<FoundLine> pieces) =>
        pieces.SelectMany(piece => piece.Stripes).GroupBy(stripe => stripe.Row).ToDictionary(row => row.Key, row => row.First());

    /// <summary>
    /// The double line of two stripes. With the distance D between them, its middle is (l + r) / 2 in rows where both were found, and
    /// l + D / 2 or r - D / 2 where one was.
    /// </summary>
    private static FoundLine Double(List<FoundLine> left, List<FoundLine> right)
    {
        Dictionary<int, StripeCluster> l = Offsets(left);
        Dictionary<int, StripeCluster> r = Offsets(right);
        double distance = Median(l, r)!.Value;
        List<StripeCluster> middle =
        [
            .. l
                .Keys.Union(r.Keys)
                .OrderBy(row => row)
                .Select(row =>
                    !r.TryGetValue(row, out StripeCluster atRight) ? l[row] with { Offset = l[row].Offset + (distance / 2) }
                    : !l.TryGetValue(row, out StripeCluster atLeft) ? atRight with { Offset = atRight.Offset - (distance / 2) }
                    : atLeft with { Offset = (atLeft.Offset + atRight.Offset) / 2 }
                ),
        ];
        List<FoundLine> pieces = [.. left, .. right];
        double stripe = (left[0].Paint.WidthMetres + right[0].Paint.WidthMetres) / 2;
        return new FoundLine(
            pieces.Min(piece => piece.From),
            pieces.Max(piece => piece.To),
            middle,
            new MarkingPaint(MarkingStyle.DoubleSolid, left[0].Paint.Colour, distance + stripe),
            pieces.Max(piece => piece.Contrast)
        );
    }
}
