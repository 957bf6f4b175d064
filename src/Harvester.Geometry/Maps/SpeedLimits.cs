namespace Harvester.Geometry.Maps;

/// <summary>
/// Gives lanes the speed limits of signs: those of the road beside which a sign stands, on its right as the traffic sees it, from there to
/// the next junction or sign. A road's part before the sign counts with it.
/// </summary>
internal static class SpeedLimits
{
    /// <summary>Greatest distance of a sign from its lanes, metres.</summary>
    private const double MaxBeside = 8;

    /// <summary>Greatest angle between what a sign faces and the traffic that comes, as its cosine: 50 degrees.</summary>
    private const double MinFacing = 0.64;

    /// <summary>Lanes farther above or below are those of another road, metres.</summary>
    private const double SameLevel = 5;

    public static void Apply(LaneNetwork map, IEnumerable<MapSpeedSign> signs)
    {
        var own = new HashSet<MapLane>();
        var found = new List<(MapLane Lane, double Limit)>();
        foreach (MapSpeedSign sign in signs)
        {
            if (LaneOf(map, sign) is { } lane && own.Add(lane))
            {
                found.Add((lane, sign.Limit));
            }
        }

        foreach ((MapLane first, double limit) in found)
        {
            for (MapLane? lane = first; lane is not null && lane.SpeedLimit is null && (lane == first || !own.Contains(lane)); )
            {
                foreach (MapLane beside in SideOf(lane))
                {
                    beside.SpeedLimit = limit;
                }

                lane = lane.Successors.FirstOrDefault(static next => next.Junction is null);
            }
        }
    }

    /// <summary>The rightmost lane of the road beside a sign whose traffic comes towards it.</summary>
    private static MapLane? LaneOf(LaneNetwork map, MapSpeedSign sign)
    {
        double length = new Vector2D(sign.Facing.X, sign.Facing.Y).Length;
        return map
            .Index.Near(sign.Position, MaxBeside)
            .Where(static lane => lane.Junction is null && lane.RightNeighbour is null)
            .Select(lane => (Lane: lane, Place: LanePiece.NearestOf(lane, sign.Position)))
            .Where(pair =>
                Math.Abs(pair.Place.Height) <= SameLevel
                && -pair.Lane.EndDirection.Dot(new Vector2D(sign.Facing.X, sign.Facing.Y)) > MinFacing * length
                && IsOnRight(pair.Lane, sign.Position)
            )
            .OrderBy(pair => pair.Place.FromLane)
            .Select(static pair => pair.Lane)
            .FirstOrDefault();
    }

    private static bool IsOnRight(MapLane lane, Vector3D place)
    {
        Vector3D middle = lane.Centre[lane.Centre.Count / 2];
        return lane.EndDirection.Cross(new Vector2D(place.X - middle.X, place.Y - middle.Y)) < 0;
    }

    private static IEnumerable<MapLane> SideOf(MapLane lane)
    {
        for (MapLane? beside = lane; beside is not null; beside = beside.LeftNeighbour)
        {
            yield return beside;
        }
    }
}
