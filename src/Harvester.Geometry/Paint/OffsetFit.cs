namespace Harvester.Geometry.Paint;

/// <summary>
/// The offset of a line at any station: a straight line fitted to the stripes around it, by least squares with weights
/// 1 / sigma² · (1 - (s / reach)²), repeated once without the stripes that miss the first fit by more than three times its median residual.
/// </summary>
internal sealed class OffsetFit(IReadOnlyList<StripeCluster> stripes)
{
    /// <summary>Half of the window, metres: long against a row, short against bends.</summary>
    private const double Reach = 6;

    /// <summary>Fewest stripes in a window; it grows until it has them: about one and a half dashes.</summary>
    private const int MinStripes = 8;

    /// <summary>Residuals up to this never count as outliers, metres.</summary>
    private const double SmallResidual = 0.02;

    private const double OutlierFactor = 3;

    /// <summary>Least standard deviation of a fitted offset, metres: what remains of errors of the camera's pose.</summary>
    private const double MinSigma = 0.005;

    /// <summary>The offset at a station, its standard deviation, and the number of images.</summary>
    public (double Offset, double Sigma, int Images) At(double station)
    {
        (List<StripeCluster> near, double reach) = Window(station);
        (double offset, double slope) = Fit(near, station, reach);
        List<double> residuals = near.ConvertAll(stripe => Residual(stripe, station, offset, slope));
        var sorted = new List<double>(residuals);
        sorted.Sort();
        double limit = Math.Max(SmallResidual, OutlierFactor * sorted[sorted.Count / 2]);
        List<StripeCluster> kept = near.FindAll(stripe => Residual(stripe, station, offset, slope) <= limit);
        (offset, _) = Fit(kept, station, reach);

        // The stripes of an image share the errors of its pose and of the ground, so that more rows do not make the mean better.
        double sigma = WeightedMedian.Of(kept.ConvertAll(stripe => (stripe.Sigma, 1.0)));
        int images = 0;
        kept.ForEach(stripe => images = Math.Max(images, stripe.Images));
        return (offset, Math.Sqrt((sigma * sigma) + (MinSigma * MinSigma)), images);
    }

    private static double Residual(StripeCluster stripe, double station, double offset, double slope) =>
        Math.Abs(stripe.Offset - offset - (slope * (stripe.Station - station)));

    private (List<StripeCluster> Near, double Reach) Window(double station)
    {
        double reach = Reach;
        while (true)
        {
            var near = new List<StripeCluster>();
            double farthest = 0;
            foreach (StripeCluster stripe in stripes)
            {
                double distance = Math.Abs(stripe.Station - station);
                farthest = Math.Max(farthest, distance);
                if (distance < reach)
                {
                    near.Add(stripe);
                }
            }

            if (near.Count >= Math.Min(MinStripes, stripes.Count))
            {
                return (near, reach);
            }

            reach = Math.Min(reach * 1.5, farthest + PaintRow.Length);
        }
    }

    private static (double Offset, double Slope) Fit(List<StripeCluster> near, double station, double reach)
    {
        (double w, double s, double o, double ss, double so) = (0, 0, 0, 0, 0);
        foreach (StripeCluster stripe in near)
        {
            double from = stripe.Station - station;
            double weight = (1 - (from * from / (reach * reach))) / (stripe.Sigma * stripe.Sigma);
            w += weight;
            s += weight * from;
            o += weight * stripe.Offset;
            ss += weight * from * from;
            so += weight * from * stripe.Offset;
        }

        // Stripes closer together than a row give no slope.
        double spread = (w * ss) - (s * s);
        if (spread < w * w * PaintRow.Length * PaintRow.Length)
        {
            return (o / w, 0);
        }

        double slope = ((w * so) - (s * o)) / spread;
        return ((o - (slope * s)) / w, slope);
    }
}
