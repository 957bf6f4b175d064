namespace Harvester.Geometry.Roads;

/// <summary>
/// A cross section of the lanes of one direction of a road. Offsets are metres to the right of the left edge of the leftmost lane.
/// </summary>
public readonly record struct LaneSection
{
    /// <summary>Distance outside the outermost lanes up to which the indicators on marking are valid, metres for lanes 4 m wide.</summary>
    internal const double ReachOutsideTheRoad = 2.0;

    /// <summary>The lane width of TORCS, metres, for which the indicators' thresholds and ranges are published.</summary>
    public const double TorcsLaneWidth = 4.0;

    /// <summary>Creates a section of equally wide lanes.</summary>
    /// <param name="laneCount">Lanes of this direction; at least 1.</param>
    /// <param name="laneWidth">Width of each, metres; greater than 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">Fewer than 1 lane, or a width that is not positive.</exception>
    public LaneSection(int laneCount, double laneWidth)
    {
        if (laneCount < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(laneCount), laneCount, "A direction has at least one lane.");
        }

        LaneCount = laneCount;
        LaneWidth = Guard.Positive(laneWidth, nameof(laneWidth));
    }

    /// <summary>Lanes of this direction.</summary>
    public int LaneCount { get; }

    /// <summary>Width of each lane, metres.</summary>
    public double LaneWidth { get; }

    /// <summary>Factor from metres on this road to metres of a TORCS road.</summary>
    public double TorcsScale => TorcsLaneWidth / LaneWidth;

    /// <summary>The lane at an offset, 0 the leftmost; null outside the lanes. A marking belongs to the lane on its right.</summary>
    public int? LaneAt(double offset)
    {
        double lane = Math.Floor(offset / LaneWidth);
        return lane >= 0 && lane < LaneCount ? (int)lane : null;
    }
}
