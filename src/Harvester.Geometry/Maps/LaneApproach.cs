namespace Harvester.Geometry.Maps;

/// <summary>The lanes of a road that lead into a junction.</summary>
/// <param name="Id">A name that depends on the road alone.</param>
/// <param name="Junction">Index of the junction.</param>
/// <param name="Segment">The road.</param>
/// <param name="Lanes">The lanes from left to right; at least one.</param>
internal sealed record LaneApproach(string Id, int Junction, RoadSegment Segment, IReadOnlyList<MapLane> Lanes)
{
    /// <summary>Where the leftmost lane's left edge ends.</summary>
    public Vector3D Left { get; } = Lanes[0].Left[Lanes[0].Left.Count - 1];

    /// <summary>Where the rightmost lane's right edge ends.</summary>
    public Vector3D Right { get; } = Lanes[Lanes.Count - 1].Right[Lanes[Lanes.Count - 1].Right.Count - 1];

    /// <summary>Unit vector of the traffic's direction on the ground.</summary>
    public Vector2D Direction { get; } = Lanes[0].EndDirection;

    /// <summary>Whether the road to the junction, over one or more links, is at least as long as this, metres.</summary>
    public bool IsAtLeast(double length) => Back(length).Any(place => place.Distance + LengthOf(place.Lane) >= length);

    /// <summary>The lanes over which the leftmost is reached from the junction behind, from the last one back, each with the distance of
    /// its end from the junction, metres.</summary>
    /// <param name="range">Greatest distance, metres.</param>
    public IEnumerable<(MapLane Lane, double Distance)> Back(double range)
    {
        double distance = 0;
        for (MapLane? lane = Lanes[0]; lane is not null && distance <= range; lane = Before(lane))
        {
            yield return (lane, distance);
            distance += LengthOf(lane);
        }
    }

    private static double LengthOf(MapLane lane) => (lane.Centre[lane.Centre.Count - 1] - lane.Centre[0]).Length;

    private static MapLane? Before(MapLane lane) => lane.Predecessors.FirstOrDefault(static before => before.Junction is null);

    /// <summary>The approaches of a network, by their road.</summary>
    public static IEnumerable<LaneApproach> Of(IEnumerable<RoadSegment> segments)
    {
        foreach (RoadSegment segment in segments)
        {
            if (segment.End.Junction is { } end && segment.Forward.Count > 0)
            {
                yield return new LaneApproach(segment.Id + "/f", end, segment, segment.Forward);
            }

            if (segment.Start.Junction is { } start && segment.Backward.Count > 0)
            {
                yield return new LaneApproach(segment.Id + "/b", start, segment, segment.Backward);
            }
        }
    }
}
