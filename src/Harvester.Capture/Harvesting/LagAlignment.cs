namespace Harvester.Capture.Harvesting;

/// <summary>
/// Compares how something moved, tick by tick, with how much the images changed. The ticks fall into three groups by the pace of the
/// movement: full, creeping and still. With the right lag, the changes within each group are similar; the cost of a lag is the sum of their
/// squared distances from the mean of the group. No scale between movement and change is assumed, only that a faster pace does not change
/// the image less.
/// </summary>
internal sealed class LagAlignment
{
    // A frozen game that still creeps does so at a fraction of its pace; braking traffic changes by a few per cent per tick.
    private const double FullFraction = 0.5;

    // Far below any creep that an image could show, far above the rounding of a still pose.
    private const double StillFraction = 0.003;

    private readonly MotionPace[] _paces;
    private readonly double[] _changes;
    private readonly int _firstChange;

    /// <summary>Groups the movements by pace.</summary>
    /// <param name="motions">The movement from the previous tick to each tick; the first is ignored.</param>
    /// <param name="fullMotion">The movement in a tick of the running game, greater than 0.</param>
    /// <param name="changes">
    /// The change of the image in each tick from <paramref name="firstChange"/> on; 1 is the change in the running game.
    /// </param>
    /// <param name="firstChange">The tick of the first change.</param>
    public LagAlignment(IEnumerable<double> motions, double fullMotion, double[] changes, int firstChange)
    {
        _paces = [.. motions.Select(motion => PaceOf(motion / fullMotion))];
        _changes = changes;
        _firstChange = firstChange;
    }

    /// <summary>
    /// The cost of a lag; infinite if a slower pace would change the image more than a faster one, or a pace was not observed.
    /// </summary>
    /// <param name="lagTicks">Ticks from a movement to the image that shows it; may be -1.</param>
    public double CostOf(int lagTicks)
    {
        double[] sums = new double[3];
        double[] squares = new double[3];
        int[] counts = new int[3];
        for (int i = 0; i < _changes.Length; i++)
        {
            // After the end of the record everything stands still.
            int tick = _firstChange + i - lagTicks;
            int pace = (int)(tick < _paces.Length ? _paces[tick] : MotionPace.Still);
            sums[pace] += _changes[i];
            squares[pace] += _changes[i] * _changes[i];
            counts[pace]++;
        }

        double[] means = [.. sums.Select((sum, pace) => counts[pace] > 0 ? sum / counts[pace] : 0)];
        int creep = (int)MotionPace.Creep;
        int still = (int)MotionPace.Still;
        int full = (int)MotionPace.Full;
        bool isOrdered =
            counts[full] > 0
            && counts[still] > 0
            && means[full] > means[still]
            && (counts[creep] == 0 || (means[creep] >= means[still] && means[creep] <= means[full]));
        return isOrdered
            ? Enumerable.Range(0, 3).Sum(pace => Math.Max(0, squares[pace] - (sums[pace] * means[pace])))
            : double.PositiveInfinity;
    }

    private static MotionPace PaceOf(double fraction) =>
        fraction >= FullFraction ? MotionPace.Full
        : fraction > StillFraction ? MotionPace.Creep
        : MotionPace.Still;
}
