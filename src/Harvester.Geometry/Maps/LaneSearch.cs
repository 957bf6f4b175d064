namespace Harvester.Geometry.Maps;

/// <summary>Finds lanes of a map by place and direction, or by their road.</summary>
internal sealed class LaneSearch
{
    /// <summary>Greatest height difference from a lane, metres; beyond it, the place is on another road.</summary>
    private const double MaxHeightDifference = 4;

    /// <summary>How far a place may lie beyond an end of a lane, metres: room for the bend between two lanes.</summary>
    private const double MaxOvershoot = 0.5;

    /// <summary>Greatest angle from the direction of a lane, radians: 60 degrees.</summary>
    private const double MaxAngle = Math.PI / 3;

    /// <summary>An angle that counts as much as half the width of a lane, radians: 20 degrees.</summary>
    private const double UsualAngle = Math.PI / 9;

    private readonly MapLane[] _lanes;
    private readonly Box2D[] _bounds;
    private readonly Dictionary<int, RoadSegment> _segments;

    /// <summary>Prepares the search.</summary>
    /// <param name="lanes">The lanes to search.</param>
    /// <param name="segments">The roads.</param>
    public LaneSearch(IReadOnlyList<MapLane> lanes, IReadOnlyList<RoadSegment> segments)
    {
        _segments = segments.ToDictionary(segment => segment.Link);
        _lanes = [.. lanes];
        _bounds = [.. _lanes.Select(BoundsOf)];
    }

    /// <summary>The road of a link; null if none of it lies outside junctions.</summary>
    public RoadSegment? SegmentOf(int link) => _segments.TryGetValue(link, out RoadSegment? segment) ? segment : null;

    /// <summary>
    /// The lane whose middle and direction fit best; of several that fit equally well, as where ways part, the first by name. Null if the
    /// place is on none.
    /// </summary>
    /// <param name="position">Metres, world, near the height of the road.</param>
    /// <param name="direction">The direction on the ground, of any length.</param>
    public MapLane? At(Vector3D position, Vector2D direction)
    {
        MapLane? best = null;
        double bestCost = double.PositiveInfinity;
        for (int i = 0; i < _lanes.Length; i++)
        {
            Box2D bounds = _bounds[i];
            if (position.X < bounds.XMin || position.X > bounds.XMax || position.Y < bounds.YMin || position.Y > bounds.YMax)
            {
                continue;
            }

            double cost = Cost(_lanes[i], position, direction);
            if (cost < bestCost || (cost == bestCost && best is { } other && string.CompareOrdinal(_lanes[i].Id, other.Id) < 0))
            {
                (best, bestCost) = (_lanes[i], cost);
            }
        }

        return best;
    }

    /// <summary>The misfit of a lane; infinite if the place is not on it.</summary>
    private static double Cost(MapLane lane, Vector3D position, Vector2D direction)
    {
        (LanePoint nearest, double overshoot) = lane.NearestTo(position);
        double angle = Math.Abs(Math.Atan2(nearest.Direction.Cross(direction), nearest.Direction.Dot(direction)));
        double aside = Math.Abs(nearest.OffsetOf(position)) * 2 / nearest.Width;
        return
            overshoot > MaxOvershoot || aside > 1 || angle > MaxAngle || Math.Abs(position.Z - nearest.Position.Z) > MaxHeightDifference
            ? double.PositiveInfinity
            : (aside * aside) + (angle / UsualAngle * (angle / UsualAngle));
    }

    private static Box2D BoundsOf(MapLane lane)
    {
        var bounds = new Box2D(double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);
        foreach (Vector3D point in lane.Left.Concat(lane.Right))
        {
            bounds = bounds.Union(new Box2D(point.X, point.Y, point.X, point.Y));
        }

        return new Box2D(
            bounds.XMin - MaxOvershoot,
            bounds.YMin - MaxOvershoot,
            bounds.XMax + MaxOvershoot,
            bounds.YMax + MaxOvershoot
        );
    }
}
