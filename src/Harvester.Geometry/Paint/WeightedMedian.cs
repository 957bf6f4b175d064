namespace Harvester.Geometry.Paint;

/// <summary>The weighted median: half of the weight lies on either side of it.</summary>
internal static class WeightedMedian
{
    public static double Of(List<(double Value, double Weight)> values)
    {
        values.Sort(static (a, b) => a.Value.CompareTo(b.Value));
        double total = 0;
        foreach ((_, double weight) in values)
        {
            total += weight;
        }

        // With the weights' sums W(i) up to the middle of value i, the median is interpolated where W = half of the total.
        double before = 0;
        for (int i = 0; i < values.Count; i++)
        {
            double at = before + (values[i].Weight / 2);
            if (at >= total / 2)
            {
                if (i == 0)
                {
                    return values[0].Value;
                }

                double previous = before - (values[i - 1].Weight / 2);
                double part = (total / 2 - previous) / (at - previous);
                return values[i - 1].Value + (part * (values[i].Value - values[i - 1].Value));
            }

            before += values[i].Weight;
        }

        return values[values.Count - 1].Value;
    }
}
