namespace Harvester.Geometry.Paint;

/// <summary>
/// Combines the stripes that several images show in a row. Stripes whose middles follow each other closely are one cluster; it counts if it
/// has at least half of the weight of the images that show its place, with weights of 1 / sigma². So what only some images show, such as
/// the reflection of the sun or a moving shadow, is left out.
/// </summary>
internal static class StripeClusters
{
    /// <summary>Largest step between neighbours of a cluster, metres: half of the distance of the lines of the narrowest double.</summary>
    private const double MaxStep = 0.07;

    private const double MinShare = 0.5;

    public static List<StripeCluster> Of(int index, ChainRow row)
    {
        var clusters = new List<StripeCluster>();
        if (row.Evidence is not { } evidence)
        {
            return clusters;
        }

        List<PaintCandidate> sorted = evidence.Candidates.ConvertAll(candidate =>
            candidate with
            {
                Offset = (float)row.Turned(candidate.Offset),
            }
        );
        sorted.Sort(static (a, b) => a.Offset != b.Offset ? a.Offset.CompareTo(b.Offset) : a.Image.CompareTo(b.Image));
        for (int begin = 0; begin < sorted.Count; )
        {
            int end = begin + 1;
            while (end < sorted.Count && sorted[end].Offset - sorted[end - 1].Offset <= MaxStep)
            {
                end++;
            }

            List<PaintCandidate> members = sorted.GetRange(begin, end - begin);
            double offset = Median(members, static member => member.Offset);
            double weight = Weight(members);
            if (weight >= MinShare * SeenWeight(row, offset))
            {
                clusters.Add(
                    new StripeCluster(
                        index,
                        row.Station,
                        offset,
                        Median(members, static member => member.Width),
                        Median(members, static member => member.Contrast),
                        Median(members, static member => member.Blueness),
                        Math.Sqrt(1 / weight),
                        Images(members)
                    )
                );
            }

            begin = end;
        }

        return clusters;
    }

    /// <summary>The weight of the images that show a place; 0 if none does.</summary>
    public static double SeenWeight(ChainRow row, double offset)
    {
        double weight = 0;
        double inLink = row.Turned(offset);
        foreach (SeenSpan seen in row.Evidence is { } evidence ? evidence.Seen : [])
        {
            if (inLink >= seen.Left && inLink <= seen.Right)
            {
                double sigma = seen.SigmaAt(inLink);
                weight += 1 / (sigma * sigma);
            }
        }

        return weight;
    }

    private static double Weight(List<PaintCandidate> members)
    {
        // Of an image with two stripes in a cluster, the better one counts.
        var best = new Dictionary<int, double>();
        foreach (PaintCandidate member in members)
        {
            double weight = 1 / (member.Sigma * member.Sigma);
            best[member.Image] = best.TryGetValue(member.Image, out double other) ? Math.Max(other, weight) : weight;
        }

        double sum = 0;
        foreach (double weight in best.Values)
        {
            sum += weight;
        }

        return sum;
    }

    private static int Images(List<PaintCandidate> members)
    {
        var images = new HashSet<int>();
        members.ForEach(member => images.Add(member.Image));
        return images.Count;
    }

    private static double Median(List<PaintCandidate> members, Func<PaintCandidate, double> value) =>
        WeightedMedian.Of(members.ConvertAll(member => (value(member), 1.0 / (member.Sigma * member.Sigma))));
}
