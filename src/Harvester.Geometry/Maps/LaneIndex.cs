namespace Harvester.Geometry.Maps;

/// <summary>Finds the lanes of a map at a place. Immutable, and so safe for any number of threads.</summary>
public sealed class LaneIndex
{
    /// <summary>Side of the cells, metres.</summary>
    private const double Cell = 32;

    /// <summary>A lane farther above or below is that of another road, metres.</summary>
    private const double SameLevel = 3;

    /// <summary>Greatest angle between a direction and that of the lane, radians: 60 degrees.</summary>
    private const double MaxTurn = Math.PI / 3;

    /// <summary>How much an angle of a radian counts beside the distance from the middle of a lane, metres.</summary>
    private const double MetresPerRadian = 3;

    private readonly GroundGrid<MapLane> _lanes = new(Cell);

    /// <summary>Prepares the lanes of a map.</summary>
    public LaneIndex(LaneNetwork map)
    {
        foreach (MapLane lane in Guard.NotNull(map, nameof(map)).Lanes)
        {
            _lanes.Add(lane, BoxOf(lane));
        }
    }

    /// <summary>
    /// The lane at a place whose traffic drives in a direction: of several, as in junctions, the one whose middle and direction fit best.
    /// </summary>
    /// <param name="position">Metres, world.</param>
    /// <param name="direction">The direction of travel; only its direction on the ground matters.</param>
    /// <returns>The lane; null if the place lies on none, or all lead elsewhere.</returns>
    public MapLane? At(Vector3D position, Vector3D direction)
    {
        MapLane? best = null;
        double least = double.PositiveInfinity;
        var wanted = new Vector2D(direction.X, direction.Y);
        foreach (MapLane lane in _lanes.Near(position.X, position.Y, 0))
        {
            LanePiece place = LanePiece.NearestOf(lane, position);
            double turn = Math.Abs(Math.Atan2(place.Direction.Cross(wanted), place.Direction.Dot(wanted)));
            double cost = place.FromMiddle + (MetresPerRadian * turn);
            if (place.IsOnLane && Math.Abs(place.Height) <= SameLevel && turn <= MaxTurn && cost < least)
            {
                (best, least) = (lane, cost);
            }
        }

        return best;
    }

    /// <summary>The lanes that come within a distance of a place, in the order of the map.</summary>
    /// <param name="place">Metres, world; its height is ignored.</param>
    /// <param name="range">Metres, on the ground; less than 0 counts as 0.</param>
    public IReadOnlyList<MapLane> Near(Vector3D place, double range) =>
        [
            .. _lanes
                .Near(place.X, place.Y, Math.Max(0, range))
                .Where(lane => LanePiece.NearestOf(lane, place).FromLane <= range)
                .OrderBy(lane => lane.Order),
        ];

    /// <summary>Where a place lies on and beside the lanes near it that are on its level, in the order of the map.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Greatest distance from a lane on the ground, metres; less than 0 counts as 0.</param>
    public IReadOnlyList<LaneSpot> SpotsAt(Vector3D place, double range)
    {
        var spots = new List<LaneSpot>();
        double reach = Math.Max(0, range);
        foreach (MapLane lane in _lanes.Near(place.X, place.Y, reach))
        {
            LanePiece piece = LanePiece.NearestOf(lane, place);
            double length = piece.Direction.Length;
            bool isOnLane = piece.IsOnLane;
            if ((isOnLane || piece.FromLane <= reach) && Math.Abs(piece.Height) <= SameLevel && length > 0)
            {
                spots.Add(
                    new LaneSpot(
                        lane,
                        piece.Direction * (1 / length),
                        piece.Along,
                        piece.IsLeft ? -piece.FromMiddle : piece.FromMiddle,
                        piece.HalfWidth,
                        isOnLane ? 0 : piece.FromLane
                    )
                );
            }
        }

        spots.Sort(static (a, b) => a.Lane.Order.CompareTo(b.Lane.Order));
        return spots;
    }

    private static Box2D BoxOf(MapLane lane)
    {
        (double west, double south, double east, double north) = (
            double.PositiveInfinity,
            double.PositiveInfinity,
            double.NegativeInfinity,
            double.NegativeInfinity
        );
        foreach (Vector3D point in lane.Left.Concat(lane.Right))
        {
            (west, east) = (Math.Min(west, point.X), Math.Max(east, point.X));
            (south, north) = (Math.Min(south, point.Y), Math.Max(north, point.Y));
        }

        return new Box2D(west, south, east, north);
    }
}
