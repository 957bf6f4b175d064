using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>
/// The lanes of a road in OpenDRIVE's terms: right of lane 0 those from start to end, -1 the innermost; left of it those from end to start,
/// 1 the innermost. Lane 0 lies on the left edge of the lanes from start to end.
/// </summary>
internal sealed class OpenDriveRoad
{
    /// <summary>Directions whose lanes lie closer than this touch, metres.</summary>
    private const double Touching = 0.001;

    public OpenDriveRoad(int id, RoadSegment segment)
    {
        Id = id;
        Segment = segment;
        Length = segment.Line.Length;
        double gap = segment.Forward.Count > 0 && segment.Backward.Count > 0 ? segment.ForwardLeftEdge + segment.BackwardLeftEdge : 0;
        GapWidth = gap > Touching ? gap : 0;

        // Offsets of lanes are to the right of the line in their own direction, OpenDRIVE's to the left of it.
        LaneOffset = segment.Forward.Count > 0 ? -segment.ForwardLeftEdge : segment.BackwardLeftEdge;
        int first = GapWidth > 0 ? 2 : 1;
        LaneIds =
        [
            .. segment.Forward.Select((lane, index) => (lane, -(index + 1))),
            .. segment.Backward.Select((lane, index) => (lane, first + index)),
        ];
    }

    public int Id { get; }

    public RoadSegment Segment { get; }

    /// <summary>Length of its line, metres.</summary>
    public double Length { get; }

    /// <summary>Width of the median, metres; 0 if there is none.</summary>
    public double GapWidth { get; }

    /// <summary>Offset of lane 0 to the left of the line, metres.</summary>
    public double LaneOffset { get; }

    /// <summary>The lanes with their ids.</summary>
    public IReadOnlyList<(MapLane Lane, int Id)> LaneIds { get; }
}
