namespace Harvester.Geometry.Paint;

/// <summary>The stripes of one painted line along a chain, in its order.</summary>
internal sealed class PaintTrack(StripeCluster first)
{
    /// <summary>The slope of the line is that of its last part of this length, metres: a dash.</summary>
    private const double SlopeWindow = 6;

    /// <summary>Least length from which a slope is computed, metres.</summary>
    private const double MinSlopeWindow = 2;

    /// <summary>Largest slope of a line against the curve of the network, whose nodes are rounded to a quarter of a metre.</summary>
    private const double MaxSlope = 0.06;

    /// <summary>Offset by which a line may miss its prediction, metres, and its growth with the distance from the last stripe.</summary>
    private const double Gate = 0.08;
    private const double GateGrowth = 0.025;
    private const double MaxGate = 0.4;

    public List<StripeCluster> Stripes { get; } = [first];

    public StripeCluster Last => Stripes[Stripes.Count - 1];

    /// <summary>How far a stripe is from where the line is expected; infinite if it cannot belong to it.</summary>
    public double Misfit(StripeCluster stripe)
    {
        double gap = stripe.Station - Last.Station;
        double misfit = Math.Abs(stripe.Offset - Predicted(stripe.Station));
        return misfit <= Math.Min(MaxGate, Gate + (GateGrowth * gap)) ? misfit : double.PositiveInfinity;
    }

    /// <summary>Offset at a station beyond the last stripe: the last one's mean offset plus slope times distance.</summary>
    private double Predicted(double station)
    {
        (double n, double s, double o, double ss, double so) = (0, 0, 0, 0, 0);
        int i = Stripes.Count - 1;
        for (; i >= 0 && Last.Station - Stripes[i].Station <= SlopeWindow; i--)
        {
            double from = Stripes[i].Station - Last.Station;
            n++;
            s += from;
            o += Stripes[i].Offset;
            ss += from * from;
            so += from * Stripes[i].Offset;
        }

        double span = Last.Station - Stripes[i + 1].Station;
        double spread = (n * ss) - (s * s);
        if (span < MinSlopeWindow || spread <= 0)
        {
            return Last.Offset;
        }

        double slope = Math.Max(-MaxSlope, Math.Min(MaxSlope, ((n * so) - (s * o)) / spread));
        return ((o - (slope * s)) / n) + (slope * (station - Last.Station));
    }
}
