using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The position of lanes across a road, in metres to the right of its line: the line runs in the middle of the median of a two-way road and
/// in the middle of a one-way road. Implemented independently of the geometry library, because it is used to test it.
/// </summary>
internal readonly record struct LaneLayout(int Forward, int Backward, double LaneWidth, double MedianWidth)
{
    private const double OrdinaryLane = 5.4;
    private const double NarrowLane = 4.0;

    /// <summary>How its lines are painted; null for the paint of ordinary roads.</summary>
    public RoadPaint? Paint { get; init; }

    public bool IsOneWay => Forward == 0 || Backward == 0;

    /// <summary>Offset of the carriageway's left edge, looking along the road.</summary>
    public double LeftEdge => IsOneWay ? -(Forward + Backward) * LaneWidth / 2 : -(MedianWidth / 2) - (Backward * LaneWidth);

    /// <summary>Offset of the carriageway's right edge.</summary>
    public double RightEdge => IsOneWay ? (Forward + Backward) * LaneWidth / 2 : (MedianWidth / 2) + (Forward * LaneWidth);

    public double HalfWidth => Math.Max(-LeftEdge, RightEdge);

    /// <summary>
    /// The layout seen in the other direction. It is a method because a record's text includes its properties, and so would recurse.
    /// </summary>
    public LaneLayout Reversed() => this with { Forward = Backward, Backward = Forward };

    public static LaneLayout Of(RoadLink link)
    {
        bool narrow = link.Flags.HasFlag(RoadLinkFlags.NarrowRoad);
        double median = link.IsOneWay ? 0 : Math.Max(0, link.MedianWidth ?? 0);
        return new LaneLayout(link.LanesForward, link.LanesBackward, narrow ? NarrowLane : OrdinaryLane, median);
    }

    public int Lanes(bool forward) => forward ? Forward : Backward;

    /// <summary>Offset of the centre of a lane; lane 0 is the leftmost as seen by its drivers.</summary>
    public double LaneCentre(bool forward, int lane)
    {
        double fromInnerEdge = (lane + 0.5) * LaneWidth;
        return IsOneWay
            ? forward
                ? LeftEdge + fromInnerEdge
                : RightEdge - fromInnerEdge
            : forward
                ? (MedianWidth / 2) + fromInnerEdge
                : -(MedianWidth / 2) - fromInnerEdge;
    }

    /// <summary>The lane at an offset; null outside the lanes and on the median.</summary>
    public (bool Forward, int Lane)? LaneAt(double offset)
    {
        bool forward = IsOneWay ? Forward > 0 : offset >= 0;
        double inner = IsOneWay ? (Forward + Backward) * -LaneWidth / 2 : MedianWidth / 2;
        int lane = (int)Math.Floor(((forward ? offset : -offset) - inner) / LaneWidth);
        return lane >= 0 && lane < Lanes(forward) ? (forward, lane) : null;
    }

    /// <summary>
    /// An offset counted in lanes, with the range in which lanes lie: from the road's line to both sides, or from the left edge of a
    /// one-way road. On a road with more lanes one way than the other the range is that of the wider side.
    /// </summary>
    public LaneOffsets InLanes(double offset)
    {
        double inner = IsOneWay ? 0 : MedianWidth / 2;
        float at = (float)((IsOneWay ? offset - LeftEdge : offset) / LaneWidth);
        double outer = inner + (LaneWidth * (IsOneWay ? Forward + Backward : Math.Max(Forward, Backward)));
        return new LaneOffsets(at, at, at, (float)(inner / LaneWidth), (float)(outer / LaneWidth));
    }

    /// <summary>The painted lines across the road, left to right.</summary>
    public IEnumerable<Marking> Markings()
    {
        RoadPaint paint = Paint ?? RoadPaint.Usual;
        bool hasMedian = MedianWidth > 0;
        if (paint.HasEdges)
        {
            bool isYellow = IsOneWay && paint.HasYellowLeftEdge;
            yield return new Marking(LeftEdge + paint.EdgeInset, isYellow ? MarkingKind.Centre : MarkingKind.Edge, paint);
        }

        if (IsOneWay)
        {
            for (int i = 1; i < Forward + Backward; i++)
            {
                yield return new Marking(LeftEdge + (i * LaneWidth), MarkingKind.LaneDashed, paint);
            }
        }
        else
        {
            for (int i = Backward - 1; i > 0; i--)
            {
                yield return new Marking(-(MedianWidth / 2) - (i * LaneWidth), MarkingKind.LaneDashed, paint);
            }

            if (!hasMedian)
            {
                yield return new Marking(0, CentreKind(paint), paint);
            }
            else
            {
                yield return new Marking(-MedianWidth / 2, MarkingKind.Centre, paint);
                yield return new Marking(MedianWidth / 2, MarkingKind.Centre, paint);
            }

            for (int i = 1; i < Forward; i++)
            {
                yield return new Marking((MedianWidth / 2) + (i * LaneWidth), MarkingKind.LaneDashed, paint);
            }
        }

        if (paint.HasEdges)
        {
            yield return new Marking(RightEdge - paint.EdgeInset, MarkingKind.Edge, paint);
        }
    }

    private MarkingKind CentreKind(RoadPaint paint) =>
        paint.Centre switch
        {
            MarkingStyle.Solid => MarkingKind.Centre,
            MarkingStyle.Dashed => MarkingKind.CentreDashed,
            MarkingStyle.DoubleSolid => MarkingKind.CentreDouble,
            _ => Forward == 1 && Backward == 1 ? MarkingKind.CentreDashed : MarkingKind.CentreDouble,
        };
}
