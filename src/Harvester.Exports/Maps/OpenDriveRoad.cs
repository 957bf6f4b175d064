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
        bool isTwoWay = segment.Forward.Count > 0 && segment.Backward.Count > 0;
        GapWidth = isTwoWay && segment.Sections.Any(section => GapAt(section) > Touching) ? Along(GapAt) : [];

        // Offsets of lanes are to the right of the line in their own direction, OpenDRIVE's to the left of it.
        LaneOffset = Along(section => segment.Forward.Count > 0 ? -section.ForwardEdges[0] : section.BackwardEdges[0]);
        int first = GapWidth.Count > 0 ? 2 : 1;
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

    /// <summary>Width of the median, metres, in pieces; empty if there is none.</summary>
    public IReadOnlyList<OpenDrivePiece> GapWidth { get; }

    /// <summary>Offset of lane 0 to the left of the line, metres, in pieces.</summary>
    public IReadOnlyList<OpenDrivePiece> LaneOffset { get; }

    /// <summary>The lanes with their ids.</summary>
    public IReadOnlyList<(MapLane Lane, int Id)> LaneIds { get; }

    /// <summary>Width of a lane, metres, in pieces.</summary>
    public IReadOnlyList<OpenDrivePiece> WidthOf(MapLane lane) =>
        Along(section => section.Edges(lane.IsForward)[lane.Index + 1] - section.Edges(lane.IsForward)[lane.Index]);

    private static double GapAt(RoadSection section) => Math.Max(0, section.ForwardEdges[0] + section.BackwardEdges[0]);

    /// <summary>A value that changes evenly between the sections.</summary>
    private OpenDrivePiece[] Along(Func<RoadSection, double> value)
    {
        IReadOnlyList<RoadSection> sections = Segment.Sections;
        return sections.Count == 1
            ? [new OpenDrivePiece(0, value(sections[0]), 0)]
            :
            [
                .. Enumerable
                    .Range(0, sections.Count - 1)
                    .Select(i =>
                    {
                        (double from, double to) = (value(sections[i]), value(sections[i + 1]));
                        return new OpenDrivePiece(sections[i].Station, from, (to - from) / (sections[i + 1].Station - sections[i].Station));
                    }),
            ];
    }
}
