using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>
/// Finds vehicles whose middle comes from the lane beside into that of another, closely ahead of it. The ego is one of both.
/// </summary>
internal sealed class CutInWatch : IEventWatch
{
    /// <summary>Greatest distance ahead at which a lane is still that of the one behind, metres.</summary>
    private const double Ahead = 100;

    /// <summary>The side over which the one that cuts in came: -1 from the left, 1 from the right.</summary>
    private readonly Dictionary<OpenEvent, int> _sides = [];
    private Dictionary<RoadUser, LaneSpot> _before = [];

    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        var now = new Dictionary<RoadUser, LaneSpot>();
        foreach (RoadUser user in reading.Roads is null ? [] : reading.Driven)
        {
            if (reading.Roads!.LaneOf(user) is { } spot)
            {
                now.Add(user, spot);
            }
        }

        HoldOpen(reading, book, now);
        RoadUser ego = reading.Ego;
        if (now.ContainsKey(ego) && _before.ContainsKey(ego))
        {
            foreach (RoadUser other in now.Keys.Where(user => !user.IsEgo && _before.ContainsKey(user)))
            {
                Look(reading, book, now, other, ego);
                Look(reading, book, now, ego, other);
            }
        }

        _before = now;
    }

    /// <summary>Begins an event if a vehicle has just come into the lane of one behind it.</summary>
    private void Look(SceneReading reading, EventBook book, Dictionary<RoadUser, LaneSpot> now, RoadUser first, RoadUser behind)
    {
        if (
            _before[first].Lane.Id == now[first].Lane.Id
            || behind.Now.Speed < EventRules.MinCutInSpeed
            || GapOf(now, first, behind) is not { } gap
            || gap / behind.Now.Speed > EventRules.CutInSeconds
            || SideOf(_before[first].Lane, now[first].Lane) is not (var side and not 0)
            || LanesOf(_before[behind]).All(lane => lane.Lane.Id != now[behind].Lane.Id)
        )
        {
            return;
        }

        OpenEvent open = book.FindOrBegin(EventKind.CutIn, reading.Seconds, first, behind);
        _sides[open] = side;
        Hold(open, reading.Seconds, gap, now);
    }

    /// <summary>An event lasts until the one that cuts in is within the lane as a whole, or in none ahead any more.</summary>
    private void HoldOpen(SceneReading reading, EventBook book, Dictionary<RoadUser, LaneSpot> now)
    {
        foreach (OpenEvent open in _sides.Keys.ToList())
        {
            (RoadUser first, RoadUser behind) = (open.Users[0], open.Users[1]);
            if (
                book.Open.Contains(open)
                && now.TryGetValue(first, out LaneSpot spot)
                && now.ContainsKey(behind)
                && GapOf(now, first, behind) is { } gap
                && (_sides[open] * spot.Right) + HalfAcross(first.Now.Box, spot) > spot.HalfWidth
            )
            {
                Hold(open, reading.Seconds, gap, now);
            }
            else
            {
                _sides.Remove(open);
            }
        }
    }

    private static void Hold(OpenEvent open, double seconds, double gap, Dictionary<RoadUser, LaneSpot> now)
    {
        (UserReading first, UserReading behind) = (open.Users[0].Now, open.Users[1].Now);
        double? time = behind.Speed > 0 ? gap / behind.Speed : null;
        if (open.Hold(seconds, time ?? double.MaxValue))
        {
            Vector2D along = now[open.Users[1]].Direction;
            Vector2D alongFirst = now[open.Users[0]].Direction;
            open.Measures =
            [
                new(EventMeasures.Gap, gap),
                new(EventMeasures.TimeGap, time),
                new(EventMeasures.ClosingSpeed, behind.Ground.Dot(along) - first.Ground.Dot(alongFirst)),
            ];
        }
    }

    /// <summary>Half of what a footprint covers across a lane, metres.</summary>
    private static double HalfAcross(BodyBox box, LaneSpot spot) =>
        (Math.Abs(box.Forward.Cross(spot.Direction)) * box.HalfLength) + (Math.Abs(box.Forward.Dot(spot.Direction)) * box.HalfWidth);

    /// <summary>On which side of a lane another lies: -1 on its left, 1 on its right; 0 if it is not the one beside it.</summary>
    private static int SideOf(MapLane from, MapLane to) =>
        IsBeside(from, to.LeftNeighbour) ? -1
        : IsBeside(from, to.RightNeighbour) ? 1
        : 0;

    /// <summary>Whether a lane is the one beside another, or ends where that begins.</summary>
    private static bool IsBeside(MapLane from, MapLane? beside) =>
        beside is not null && (from.Id == beside.Id || beside.Predecessors.Any(lane => lane.Id == from.Id && lane.Junction is null));

    /// <summary>
    /// Distance along the lane from the front of the one behind to the rear of the one ahead, metres, at least 0; null if the middle of
    /// the one is not ahead of that of the other in its lane.
    /// </summary>
    private static double? GapOf(Dictionary<RoadUser, LaneSpot> now, RoadUser ahead, RoadUser behind)
    {
        LaneSpot spot = now[ahead];
        foreach ((MapLane lane, double start) in LanesOf(now[behind]))
        {
            double distance = start + spot.Along;
            if (lane.Id == spot.Lane.Id && distance > 0)
            {
                return Math.Max(0, distance - ahead.Now.Box.HalfLength - behind.Now.Box.HalfLength);
            }
        }

        return null;
    }

    /// <summary>
    /// A lane and those that continue it without a junction, each with the distance of its start from a place on the first, metres.
    /// </summary>
    private static List<(MapLane Lane, double Start)> LanesOf(LaneSpot from)
    {
        var lanes = new List<(MapLane Lane, double Start)>();
        double start = -from.Along;
        for (MapLane? lane = from.Lane; lane is not null && start <= Ahead && lanes.TrueForAll(each => each.Lane != lane); )
        {
            lanes.Add((lane, start));
            start += lane.Length;
            lane = lane.Successors.FirstOrDefault(static next => next.Junction is null);
        }

        return lanes;
    }
}
