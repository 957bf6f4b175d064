using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>Actors that come to the ego's junction from another road.</summary>
internal static class JunctionTracks
{
    /// <summary>Cosine of the greatest angle between a road and the direction from which it is said to come.</summary>
    private const double Side = 0.7;

    /// <summary>Minimum distance from the ego's path at which an actor from the side begins, metres: beyond the edge of its road.</summary>
    private const double Beside = 10;

    /// <summary>Where lines come so near to each other, two cars on them would touch, metres.</summary>
    private const double Meeting = 1.5;

    /// <summary>The lanes that come into the junction ahead from a side.</summary>
    public static IEnumerable<MapLane> ApproachesFrom(StagePlace place, ScenarioApproach approach)
    {
        if (place.Junction is not { } junction)
        {
            return [];
        }

        Vector3D wanted = DirectionFrom(place, junction, approach);
        return junction
            .Junction.Ways.SelectMany(way => way.Predecessors)
            .Distinct()
            .Where(lane => lane != junction.Lane && lane.EndDirection.Dot(new Vector2D(wanted.X, wanted.Y)) > Side)
            .OrderBy(lane => lane.Id, StringComparer.Ordinal);
    }

    /// <summary>The direction in which traffic from a side drives: from the left to the right, and the other way round.</summary>
    private static Vector3D DirectionFrom(StagePlace place, StageJunction junction, ScenarioApproach approach) =>
        approach switch
        {
            ScenarioApproach.Left => place.Track.RightAt(junction.Entry - 1),
            ScenarioApproach.Right => -place.Track.RightAt(junction.Entry - 1),
            _ => -place.Track.DirectionAt(junction.Entry - 1),
        };

    /// <summary>Binds an actor that begins on another road.</summary>
    /// <exception cref="UnfitPlaceException">No such road comes in, or it is too short.</exception>
    public static BoundActor Bind(StagePlace place, Scenario scenario, ScenarioActor actor, Func<Vector3D, double, StageActor> spawned)
    {
        MapTurn turn =
            scenario
                .Events.FirstOrDefault(each => each.Actor == actor.Id && each.Action.Kind == ScenarioActionKind.RunJunction)
                ?.Action.Turn
            ?? MapTurn.Straight;
        foreach (MapLane lane in ApproachesFrom(place, actor.Start.Approach))
        {
            if (lane.Successors.All(way => way.Turn != turn))
            {
                continue;
            }

            LaneTrack track = LaneTracks.Of(lane, lane.Length, turn);
            (double Ego, double Other)? meeting = MeetingOf(place, track);
            if (
                actor.Start.SecondsBefore is not null
                && (meeting is not { } point || !LeadsAcross(place, track, point.Other, actor.Start.Approach, turn))
            )
            {
                continue;
            }

            double speed = actor.Speed ?? scenario.Ego.Speed;

            // Both keep their speeds: the ego is at the meeting point after its way over its speed.
            double at = actor.Start.SecondsBefore is { } seconds
                ? meeting!.Value.Other - (speed * ((meeting.Value.Ego / scenario.Ego.Speed) - seconds))
                : -actor.Start.MetresBefore!.Value;
            if (
                at < track.From + 1
                || !IsOnItsSide(place, actor.Start.Approach, track.PositionAt(at))
                || track.DirectionAt(at).Dot(DirectionFrom(place, place.Junction!, actor.Start.Approach)) < Side
            )
            {
                continue;
            }

            track = track.Shifted(at);
            Vector3D forward = track.DirectionAt(0);
            return new BoundActor(
                actor,
                spawned(track.Beside(0, actor.Start.MetresRight), PathFollower.HeadingOf(new Vector2D(forward.X, forward.Y))),
                track
            )
            {
                Line = -at,
                Right = actor.Start.MetresRight,
            };
        }

        string side = actor.Start.Approach.ToString().ToLowerInvariant();
        throw new UnfitPlaceException($"No road from the {side} is long enough for '{actor.Id}' and meets the ego's way.");
    }

    /// <summary>
    /// Whether a way leads where it should beside the ego's: from its side to the other, which two roads that become one do not, or
    /// if it turns right from the right into the ego's lane.
    /// </summary>
    private static bool LeadsAcross(StagePlace place, LaneTrack track, double meeting, ScenarioApproach approach, MapTurn turn)
    {
        const double after = 12;
        const double aside = 4;
        const double farther = 30;
        double right = RightAt(meeting + after);
        return (approach, turn) switch
        {
            (ScenarioApproach.Left, MapTurn.Straight) or (ScenarioApproach.Oncoming, MapTurn.Left) => right > aside,
            (ScenarioApproach.Right, MapTurn.Straight) => right < -aside,
            (ScenarioApproach.Right, MapTurn.Right) => Math.Abs(right) < Meeting && Math.Abs(RightAt(meeting + farther)) < Meeting,
            _ => true,
        };

        double RightAt(double at) => place.Track.Locate(track.PositionAt(at)).Right;
    }

    /// <summary>Whether a start is on the side from which an actor is to come; a road that winds may lead elsewhere.</summary>
    private static bool IsOnItsSide(StagePlace place, ScenarioApproach approach, Vector3D start)
    {
        (double at, double right) = place.Track.Locate(start);
        return approach switch
        {
            ScenarioApproach.Left => right < -Beside,
            ScenarioApproach.Right => right > Beside,
            _ => at > place.Junction!.Entry,
        };
    }

    /// <summary>
    /// Where a track crosses the ego's, or first comes to it if it does not lead to the other side, as distances along both; null if it
    /// does not near the junction.
    /// </summary>
    private static (double Ego, double Other)? MeetingOf(StagePlace place, LaneTrack track)
    {
        const double step = 0.5;
        const double behind = 40;
        StageJunction junction = place.Junction!;
        (double Ego, double Other, double Right)? first = null;
        (double Ego, double Other, double Right) before = default;
        (double Ego, double Other)? crossing = null;
        for (double other = 0; other < Math.Min(track.To, behind); other += step)
        {
            (double at, double right) = place.Track.Locate(track.PositionAt(other), junction.Entry);
            bool isNear = Math.Abs(right) < Meeting && at > junction.Entry - 1 && at < junction.Exit + behind;
            if (first is { } met)
            {
                if (crossing is null && right * met.Right <= 0)
                {
                    // Between two points on both sides the distances are linear: r = 0 at the fraction r₀ / (r₀ - r).
                    double part = right == before.Right ? 0 : before.Right / (before.Right - right);
                    crossing = (before.Ego + ((at - before.Ego) * part), before.Other + (step * part));
                }

                if (!isNear)
                {
                    return right * met.Right < 0 ? crossing : (met.Ego, met.Other);
                }
            }
            else if (isNear)
            {
                first = (at, other, right);
            }

            before = (at, other, right);
        }

        return first is { } last ? (last.Ego, last.Other) : null;
    }
}
