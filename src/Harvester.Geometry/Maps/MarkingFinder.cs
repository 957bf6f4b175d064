using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// Finds the lines painted along the edges of lanes: a line counts where it lies near an edge, and for the lane if it does along most of
/// it. What is not found is unknown, not absent.
/// </summary>
/// <param name="curves">The centre lines.</param>
/// <param name="lanes">The widths of the lanes, which say where their edges are along a link.</param>
/// <param name="content">The paint.</param>
internal sealed class MarkingFinder(RoadCurves curves, LaneModel lanes, MapContent content)
{
    /// <summary>Distance of the places on an edge, metres.</summary>
    private const double Step = 1;

    /// <summary>Greatest distance of a line from an edge, metres: less than half of the narrowest lane.</summary>
    private const double MaxAside = 0.75;

    /// <summary>Lines farther above or below are those of another road, metres.</summary>
    private const double SameLevel = 2;

    /// <summary>The part of an edge along which a line must lie.</summary>
    private const double MinShare = 0.5;

    private readonly KnownPaint _known = new(content.KnownLines);

    /// <summary>Notes the lines along the lanes of a road.</summary>
    /// <param name="segment">The road.</param>
    /// <param name="from">Where it begins on its link, metres from the link's start.</param>
    /// <param name="to">Where it ends.</param>
    public void Mark(RoadSegment segment, double from, double to)
    {
        if (content.Paint?.Of(segment.Link) is not null || content.KnownLines.Count > 0)
        {
            Mark(segment.Forward, segment.Link, isForward: true, from, to);
            Mark(segment.Backward, segment.Link, isForward: false, from, to);
        }
    }

    private void Mark(IReadOnlyList<MapLane> side, int link, bool isForward, double from, double to)
    {
        for (int edge = 0; side.Count > 0 && edge <= side.Count; edge++)
        {
            MapMarking? marking = Along(link, isForward, edge, from, to);
            if (edge < side.Count)
            {
                side[edge].LeftMarking = marking;
            }

            if (edge > 0)
            {
                side[edge - 1].RightMarking = marking;
            }
        }
    }

    private MapMarking? Along(int link, bool isForward, int edge, double from, double to)
    {
        int places = Math.Max(2, (int)Math.Ceiling((to - from) / Step));
        var found = new List<MapMarking>();
        for (int i = 0; i < places; i++)
        {
            double station = from + ((to - from) * (i + 0.5) / places);
            (LaneSection section, double left) = lanes.LanesOf(link, isForward, station)!.Value;
            double offset = (isForward ? 1 : -1) * (left + section.Edge(edge));
            if ((KnownAt(link, station, offset) ?? MeasuredAt(link, station, offset)) is { } marking)
            {
                found.Add(marking);
            }
        }

        return found.Count < MinShare * places
            ? null
            : found
                .GroupBy(static marking => marking)
                .OrderByDescending(static group => group.Count())
                .Select(static group => group.Key)
                .First();
    }

    private MapMarking? MeasuredAt(int link, double station, double offset)
    {
        LinePaint? best = null;
        double least = MaxAside;
        foreach (LinePaint line in content.Paint?.Of(link)?.Lines ?? [])
        {
            double aside = Math.Abs(line.OffsetAt(station) - offset);
            if (line.FromStation <= station && station <= line.ToStation && aside <= least)
            {
                (best, least) = (line, aside);
            }
        }

        return best is null ? null : new MapMarking(best.Paint, MapSource.Measured);
    }

    private MapMarking? KnownAt(int link, double station, double offset)
    {
        if (content.KnownLines.Count == 0)
        {
            return null;
        }

        RoadCurve curve = curves.Of(link);
        Vector3D place = curve.PointBeside(curve.ParameterAt(station), offset);
        return _known.Nearest(place, MaxAside, SameLevel) is { } paint ? new MapMarking(paint, MapSource.Known) : null;
    }
}
