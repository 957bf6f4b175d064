using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>Whether a place has what a scenario needs.</summary>
internal static class PlaceNeeds
{
    /// <summary>A road is straight if its direction changes by less than this, radians.</summary>
    private const double Straight = 0.03;
    private const double Step = 5;

    /// <summary>Why the ego cannot begin on a lane, as a sentence, judged without its surroundings; null if nothing speaks against it.
    /// </summary>
    public static string? LackOf(ScenarioNeeds needs, MapLane lane)
    {
        int left = Count(lane, each => each.LeftNeighbour);
        int right = Count(lane, each => each.RightNeighbour);
        return left + right + 1 < needs.Lanes
                ? FormattableString.Invariant($"The road has {left + right + 1} lanes in the ego's direction; {needs.Lanes} are needed.")
            : left < needs.LanesLeft
                ? FormattableString.Invariant($"{left} lanes are to the left of the ego's; {needs.LanesLeft} are needed.")
            : right < needs.LanesRight
                ? FormattableString.Invariant($"{right} lanes are to the right of the ego's; {needs.LanesRight} are needed.")
            : null;
    }

    /// <summary>Checks that the lanes beside the ego's are there all along a stretch.</summary>
    /// <param name="needs">What the place must have.</param>
    /// <param name="place">The place.</param>
    /// <param name="from">Where the stretch begins, metres from the ego's start, negative behind it.</param>
    /// <param name="to">Where it ends.</param>
    /// <exception cref="UnfitPlaceException">A lane ends before.</exception>
    public static void CheckLanes(ScenarioNeeds needs, StagePlace place, double from, double to)
    {
        if (needs.Lanes <= 1 && needs.LanesLeft == 0 && needs.LanesRight == 0)
        {
            return;
        }

        for (double at = from; at <= to; at += Step)
        {
            string where = FormattableString.Invariant($"{Math.Abs(at):0} m {(at < 0 ? "behind" : "ahead of")} the ego");
            Need(place.LaneAt(at) is not null, $"A junction is {where}, where there must be lanes beside its own.");
            Need(LackOf(needs, place.LaneAt(at)!) is null, $"A lane beside the ego's ends {where}.");
        }
    }

    /// <summary>Whether a node of the roads is one near which there may be what a place must have: a crossing, or lights.</summary>
    public static bool MayBeNear(ScenarioNeeds needs, RoadNode node)
    {
        const RoadNodeFlags crossing =
            RoadNodeFlags.PedestrianCrossing | RoadNodeFlags.PedestrianCrossingWithoutWait | RoadNodeFlags.PedestrianAssisted;
        return needs.Crossing is not null
            ? (node.Flags & crossing) != 0
            : needs.Junction?.Light != true || node.Flags.HasFlag(RoadNodeFlags.TrafficLight);
    }

    /// <summary>Checks what <see cref="LackOf"/> does not look at.</summary>
    /// <exception cref="UnfitPlaceException">It lacks something.</exception>
    public static void Check(ScenarioNeeds needs, StagePlace place)
    {
        Need(place.Track.To >= needs.Metres, $"The road leads on for {place.Track.To:0} m; {needs.Metres:0} are needed.");
        Need(!needs.OncomingLane || place.OncomingAt(0) is not null, $"No lane of the other direction is beside the ego's.");
        Need(!needs.Street || IsStreet(place, 0), $"The road is no street: it is a motorway or unpaved.");
        CheckStraight(needs.StraightMetres, place);
        if (needs.Crossing is { } crossing)
        {
            Need(
                CrossingOf(place, crossing.From, crossing.To) is not null,
                $"No pedestrian crossing lies {crossing.From:0} to {crossing.To:0} m ahead."
            );
        }

        if (needs.Junction is { } junction)
        {
            CheckJunction(junction, place);
        }
    }

    /// <summary>The first pedestrian crossing between two distances ahead; null if there is none.</summary>
    public static PlacedCrossing? CrossingOf(StagePlace place, double from, double to)
    {
        const double farthest = 6;
        PlacedCrossing? nearest = null;
        foreach (MapCrossing crossing in place.Map.Crossings)
        {
            Vector3D middle = crossing.Corners.Aggregate(Vector3D.Zero, (sum, corner) => sum + corner) / crossing.Corners.Count;
            if ((middle - place.Track.PositionAt(0)).Length > to + farthest)
            {
                continue;
            }

            (double at, _) = place.Track.Locate(middle);
            if (at < from || at > to || at >= (nearest?.At ?? double.PositiveInfinity))
            {
                continue;
            }

            double[] across = [.. crossing.Corners.Select(corner => (corner - place.Track.PositionAt(at)).Dot(place.Track.RightAt(at)))];
            double[] along = [.. crossing.Corners.Select(corner => (corner - place.Track.PositionAt(at)).Dot(place.Track.DirectionAt(at)))];

            // It must lie across the track, not along it: on both sides of it and not too deep.
            if (across.Min() < -1 && across.Max() > 1 && along.Max() - along.Min() < farthest)
            {
                nearest = new PlacedCrossing(at, across.Min(), across.Max());
            }
        }

        return nearest;
    }

    private static void CheckStraight(double metres, StagePlace place)
    {
        Vector3D first = place.Track.DirectionAt(0);
        for (double at = 0; at <= metres; at += Step)
        {
            Need(
                place.Track.DirectionAt(at).Dot(first) > Math.Cos(Straight)
                    && (place.Junction is not { } junction || junction.Entry > metres),
                $"The road bends or meets a junction within {metres:0} m."
            );
        }
    }

    private static void CheckJunction(ScenarioJunction wanted, StagePlace place)
    {
        if (place.Junction is not { } junction)
        {
            throw new UnfitPlaceException("No junction lies ahead.");
        }

        Need(
            junction.Entry >= wanted.From && junction.Entry <= wanted.To,
            $"The junction is {junction.Entry:0} m ahead; it must be {wanted.From:0} to {wanted.To:0} m."
        );
        Need(
            wanted.Light is null || wanted.Light == junction.HasLight,
            wanted.Light == true ? $"The junction ahead has no lights." : (FormattableString)$"The junction ahead has lights."
        );
        foreach (ScenarioApproach approach in wanted.Approaches)
        {
            string side = approach == ScenarioApproach.Oncoming ? "other side" : approach.ToString().ToLowerInvariant();
            Need(JunctionTracks.ApproachesFrom(place, approach).Any(), $"No road comes into the junction ahead from the {side}.");
        }
    }

    private static bool IsStreet(StagePlace place, double at)
    {
        const RoadNodeFlags none = RoadNodeFlags.Highway | RoadNodeFlags.OffRoad | RoadNodeFlags.Tunnel;
        if (place.LaneAt(at)?.Link is not { } number)
        {
            return false;
        }

        RoadLink link = place.Map.Network.Links[number];
        return (place.Map.Network.Nodes[link.From].Flags & place.Map.Network.Nodes[link.To].Flags & none) == 0;
    }

    private static int Count(MapLane lane, Func<MapLane, MapLane?> next)
    {
        int count = 0;
        for (MapLane? other = next(lane); other is not null; other = next(other))
        {
            count++;
        }

        return count;
    }

    private static void Need(bool isMet, FormattableString otherwise)
    {
        if (!isMet)
        {
            throw new UnfitPlaceException(FormattableString.Invariant(otherwise));
        }
    }
}
