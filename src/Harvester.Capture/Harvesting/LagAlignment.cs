using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Compares how something moved, tick by tick, with how much the pictures changed. The ticks fall into three groups by the pace of the
/// movement: full, creeping and still. With the right lag the changes within each group are alike; what they still differ, the sum of their
/// squared distances from the mean of the group, is the cost of a lag. No scale between movement and change is assumed, only that a faster
/// pace does not change the picture less.
/// </summary>
internal sealed class LagAlignment
{
    // A frozen game that creeps on does so at a fraction of its pace; traffic that brakes changes by some per cent a tick.
    private const double FullFraction = 0.5;

    // Far below any creep that a picture could show, far above what rounding leaves of a standing pose.
    private const double StillFraction = 0.003;

    private readonly MotionPace[] _paces;
    private readonly double[] _changes;
    private readonly int _firstChange;

    /// <summary>Groups the movements by pace.</summary>
    /// <param name="motions">The movement from the tick before to each tick; the first is of no meaning.</param>
    /// <param name="fullMotion">The movement in a tick of the running game, greater than 0.</param>
    /// <param name="changes">
    /// The change of the picture in each tick from <paramref name="firstChange"/> on, 1 as in the running game.
    /// </param>
    /// <param name="firstChange">The tick of the first change.</param>
    public LagAlignment(IEnumerable<double> motions, double fullMotion, double[] changes, int firstChange)
    {
        _paces = [.. motions.Select(motion => PaceOf(motion / fullMotion))];
        _changes = changes;
        _firstChange = firstChange;
    }

    /// <summary>
    /// The cost of a lag; infinite where a slower pace would change the picture more than a faster one, or a pace is on no record.
    /// </summary>
    /// <param name="lagTicks">Ticks from a movement to the picture that shows it; may be -1.</param>
    public double CostOf(int lagTicks)
    {
        double[] sums = new double[3];
        double[] squares = new double[3];
        int[] counts = new int[3];
        for (int i = 0; i < _changes.Length; i++)
        {
            // After the end of the record all stands.
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
        bool isOrdered = counts[full] > 0 && counts[still] > 0 && means[full] > means[still]
            && (counts[creep] == 0 || (means[creep] >= means[still] && means[creep] <= means[full]));
        return isOrdered ? Enumerable.Range(0, 3).Sum(pace => Math.Max(0, squares[pace] - (sums[pace] * means[pace])))
            : double.PositiveInfinity;
    }

    private static MotionPace PaceOf(double fraction) =>
        fraction >= FullFraction ? MotionPace.Full : fraction > StillFraction ? MotionPace.Creep : MotionPace.Still;
}
