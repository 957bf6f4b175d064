namespace Harvester.Geometry.Roads;

/// <summary>
/// A cross section of the lanes of one direction of a road. Offsets are metres to the right of the left edge of the leftmost lane. Edge i
/// is the left edge of lane i, and the right edge of lane i - 1.
/// </summary>
public readonly record struct LaneSection
{
    /// <summary>Distance outside the outermost lanes up to which the indicators on marking are valid, metres for lanes 4 m wide.</summary>
    internal const double ReachOutsideTheRoad = 2.0;

    /// <summary>The lane width of TORCS, metres, for which the indicators' thresholds and ranges are published.</summary>
    public const double TorcsLaneWidth = 4.0;

    /// <summary>Widths that differ by less are the same, metres: a digit less than labels have.</summary>
    private const double SameWidth = 0.001;

    /// <summary>Offsets of the edges; null if all lanes have the same width.</summary>
    private readonly double[]? _edges;

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

    /// <summary>Creates a section of lanes that may have different widths.</summary>
    /// <param name="laneWidths">Width of each lane from left to right, metres; greater than 0. At least one.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no lane, or a width is not positive.</exception>
    public LaneSection(IReadOnlyList<double> laneWidths)
    {
        LaneCount = Guard.AtLeast(Guard.NotNull(laneWidths, nameof(laneWidths)).Count, 1, nameof(laneWidths));
        _edges = new double[LaneCount + 1];
        for (int i = 0; i < LaneCount; i++)
        {
            _edges[i + 1] = _edges[i] + Guard.Positive(laneWidths[i], nameof(laneWidths));
        }

        LaneWidth = _edges[LaneCount] / LaneCount;
    }

    /// <summary>Lanes of this direction.</summary>
    public int LaneCount { get; }

    /// <summary>Mean width of the lanes, metres.</summary>
    public double LaneWidth { get; }

    /// <summary>Width of all lanes together, metres.</summary>
    public double Width => Edge(LaneCount);

    /// <summary>Factor from metres on this road to metres of a TORCS road.</summary>
    public double TorcsScale => TorcsLaneWidth / LaneWidth;

    /// <summary>Offset of an edge, metres.</summary>
    /// <param name="edge">Number of the edge, 0 to <see cref="LaneCount"/>.</param>
    public double Edge(int edge) => _edges is null ? edge * LaneWidth : _edges[edge];

    /// <summary>Offset of the middle of a lane, metres.</summary>
    /// <param name="lane">The lane, 0 the leftmost.</param>
    public double MiddleOf(int lane) => _edges is null ? (lane + 0.5) * LaneWidth : (_edges[lane] + _edges[lane + 1]) / 2;

    /// <summary>Width of a lane, metres.</summary>
    /// <param name="lane">The lane, 0 the leftmost.</param>
    public double WidthOf(int lane) => _edges is null ? LaneWidth : _edges[lane + 1] - _edges[lane];

    /// <summary>Widths of the lanes from left to right, metres; null if all have the same width to a millimetre.</summary>
    public IReadOnlyList<double>? LaneWidths
    {
        get
        {
            double[] widths = [.. Enumerable.Range(0, LaneCount).Select(WidthOf)];
            return widths.Max() - widths.Min() < SameWidth ? null : widths;
        }
    }

    /// <summary>
    /// A distance across this road as it would be on a road of TORCS: each lane is stretched to 4 m, and what lies outside the lanes as the
    /// lane beside it.
    /// </summary>
    /// <param name="offset">Where the distance begins, metres.</param>
    /// <param name="distance">Metres, positive to the right.</param>
    public double TorcsDistance(double offset, double distance) =>
        _edges is null ? distance * TorcsScale : TorcsOffset(offset + distance) - TorcsOffset(offset);

    /// <summary>The lane at an offset, 0 the leftmost; null outside the lanes. A marking belongs to the lane on its right.</summary>
    public int? LaneAt(double offset) => offset >= 0 && offset < Width ? NearestLane(offset) : null;

    /// <summary>The lane at an offset, or the outermost one on its side outside the lanes.</summary>
    public int NearestLane(double offset)
    {
        int lane = 0;
        while (lane < LaneCount - 1 && offset >= Edge(lane + 1))
        {
            lane++;
        }

        return lane;
    }

    /// <summary>The edge nearest to an offset.</summary>
    public int NearestEdge(double offset)
    {
        int lane = NearestLane(offset);
        return offset > MiddleOf(lane) ? lane + 1 : lane;
    }

    // 4 (lane + part of the lane to the left of the offset).
    private double TorcsOffset(double offset)
    {
        int lane = NearestLane(offset);
        return TorcsLaneWidth * (lane + ((offset - Edge(lane)) / WidthOf(lane)));
    }

    /// <inheritdoc/>
    public bool Equals(LaneSection other) =>
        LaneCount == other.LaneCount && LaneWidth.Equals(other.LaneWidth) && (_edges ?? []).SequenceEqual(other._edges ?? []);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((LaneCount * 397) ^ LaneWidth.GetHashCode());
}
