namespace Harvester.Geometry.Paint;

/// <summary>
/// Follows lines along a chain: in each row, the stripes nearest to where the lines are expected continue them, the best fit first; the
/// others begin new lines.
/// </summary>
internal static class PaintTracker
{
    /// <summary>
    /// Largest gap in a line, metres: the gaps of the longest pattern in use, 9 to 12 m, or a vehicle that hides a part of it.
    /// </summary>
    private const double MaxGap = 14;

    public static List<PaintTrack> Track(PaintChain chain)
    {
        var ended = new List<PaintTrack>();
        var active = new List<PaintTrack>();
        for (int i = 0; i < chain.Rows.Count; i++)
        {
            ChainRow row = chain.Rows[i];
            ended.AddRange(active.Where(track => row.Station - track.Last.Station > MaxGap));
            active.RemoveAll(track => row.Station - track.Last.Station > MaxGap);
            List<StripeCluster> stripes = StripeClusters.Of(i, row);
            var pairs = new List<(double Misfit, int Track, int Stripe)>();
            for (int t = 0; t < active.Count; t++)
            {
                for (int s = 0; s < stripes.Count; s++)
                {
                    double misfit = active[t].Misfit(stripes[s]);
                    if (!double.IsInfinity(misfit))
                    {
                        pairs.Add((misfit, t, s));
                    }
                }
            }

            pairs.Sort();
            var takenTracks = new HashSet<int>();
            var takenStripes = new HashSet<int>();
            foreach ((_, int t, int s) in pairs)
            {
                if (!takenTracks.Contains(t) && !takenStripes.Contains(s))
                {
                    takenTracks.Add(t);
                    takenStripes.Add(s);
                    active[t].Stripes.Add(stripes[s]);
                }
            }

            for (int s = 0; s < stripes.Count; s++)
            {
                if (!takenStripes.Contains(s))
                {
                    active.Add(new PaintTrack(stripes[s]));
                }
            }
        }

        ended.AddRange(active);
        return ended;
    }
}
