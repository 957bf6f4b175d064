using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>Finds where the actors of a scenario begin at a place, or says why it cannot happen there.</summary>
public sealed class ScenarioBinder
{
    /// <summary>A place is on a lane at most this far away, metres.</summary>
    private const double NearestLane = 15;

    private readonly Scenario _scenario;
    private readonly StagePlace _place;
    private readonly int _seed;

    private ScenarioBinder(Scenario scenario, StagePlace place, int seed) => (_scenario, _place, _seed) = (scenario, place, seed);

    /// <summary>Binds a scenario.</summary>
    /// <param name="scenario">The scenario, with the values of its parameters drawn.</param>
    /// <param name="map">The lanes around the place.</param>
    /// <param name="position">Where the ego begins, metres, world.</param>
    /// <param name="direction">Where it looks.</param>
    /// <param name="seed">Chooses models and colours.</param>
    /// <param name="reason">Why it cannot happen there, as a sentence; null if it can.</param>
    /// <returns>Null if it cannot happen there.</returns>
    public static BoundScenario? Bind(
        Scenario scenario,
        LaneNetwork map,
        Vector3D position,
        Vector3D direction,
        int seed,
        out string? reason
    )
    {
        if (scenario is null)
        {
            throw new ArgumentNullException(nameof(scenario));
        }

        if ((map ?? throw new ArgumentNullException(nameof(map))).Index.At(position, direction) is not { Junction: null } lane)
        {
            reason = "The ego is on no lane.";
            return null;
        }

        if (PlaceNeeds.LackOf(scenario.Place, lane) is { } lack)
        {
            reason = lack;
            return null;
        }

        StagePlace place = StagePlace.On(map, lane, position, scenario.Ego.Turn);

        try
        {
            PlaceNeeds.Check(scenario.Place, place);
            PlaceNeeds.CheckLanes(scenario.Place, place, HindmostOf(scenario), scenario.Place.StraightMetres);
            var binder = new ScenarioBinder(scenario, place, seed);
            BoundActor[] actors = [.. scenario.Actors.Select(binder.Bound)];
            reason = null;
            return new BoundScenario(scenario, place, actors);
        }
        catch (UnfitPlaceException e)
        {
            reason = e.Message;
            return null;
        }
    }

    /// <summary>Binds a scenario on the lane that is nearest to a place.</summary>
    /// <param name="scenario">The scenario, with the values of its parameters drawn.</param>
    /// <param name="map">The lanes around the place.</param>
    /// <param name="near">The place, metres, world.</param>
    /// <param name="headingDegrees">Direction of the ego there, degrees counter-clockwise from north; null for that of the nearest
    /// lane.</param>
    /// <param name="seed">Chooses models and colours.</param>
    /// <param name="reason">Why it cannot happen there, as a sentence; null if it can.</param>
    /// <returns>Null if it cannot happen there.</returns>
    public static BoundScenario? BindNear(
        Scenario scenario,
        LaneNetwork map,
        Vector2D near,
        double? headingDegrees,
        int seed,
        out string? reason
    )
    {
        if (map is null)
        {
            throw new ArgumentNullException(nameof(map));
        }

        var place = new Vector3D(near.X, near.Y, 0);
        Vector3D? wanted = headingDegrees is { } heading ? Axes.FromHeading(heading).Forward : null;
        MapLane? lane = map
            .Index.Near(place, NearestLane)
            .Where(lane => lane.Junction is null)
            .Where(lane => wanted is not { } direction || lane.StartDirection.Dot(new Vector2D(direction.X, direction.Y)) > 0)
            .OrderBy(lane => lane.Centre.Min(point => new Vector2D(point.X - near.X, point.Y - near.Y).Length))
            .FirstOrDefault();
        if (lane is null)
        {
            reason = FormattableString.Invariant($"No lane is at {near.X}, {near.Y}.");
            return null;
        }

        var track = new LaneTrack(lane.Centre);
        double along = Math.Max(1, Math.Min(Math.Max(1, track.To - 1), track.Locate(place).At));
        return Bind(scenario, map, track.PositionAt(along), track.DirectionAt(along), seed, out reason);
    }

    /// <summary>Where the hindmost actor on a lane begins, metres from the ego's start; 0 if none begins behind it.</summary>
    private static double HindmostOf(Scenario scenario) =>
        scenario.Actors.Where(actor => actor.Start.Kind == ScenarioPlaceKind.Lane).Select(actor => actor.Start.MetresAhead).Append(0).Min();

    private BoundActor Bound(ScenarioActor actor, int index)
    {
        ScenarioStart start = actor.Start;
        return start.Kind switch
        {
            ScenarioPlaceKind.Lane => OnLane(actor, index),
            ScenarioPlaceKind.Roadside => Beside(
                actor,
                index,
                start.MetresAhead,
                RoadsidePlaces.OffsetOf(_place, start) ?? throw new UnfitPlaceException($"There is no roadside where '{actor.Id}' begins.")
            ),
            ScenarioPlaceKind.Crossing => AtCrossing(actor, index),
            ScenarioPlaceKind.Junction => JunctionTracks.Bind(_place, _scenario, actor, Spawned(actor, index)),
            _ => AtPoint(actor, index),
        };
    }

    private BoundActor OnLane(ScenarioActor actor, int index)
    {
        ScenarioStart start = actor.Start;
        double at = start.MetresAhead;
        Within(actor, at);
        (LaneTrack track, double zero) = TrackOf(actor, at);
        bool isAgainst = Math.Cos(start.HeadingDegrees * Math.PI / 180) < 0;
        if (isAgainst)
        {
            (track, zero) = (track.Reversed(), -zero);
        }

        track = track.Shifted(zero);
        double right = start.MetresRight * (track.DirectionAt(0).Dot(_place.Track.DirectionAt(at)) < 0 ? -1 : 1);
        double heading = HeadingOf(track.DirectionAt(0)) + start.HeadingDegrees - (isAgainst ? 180 : 0);
        return new BoundActor(actor, Spawned(actor, index)(track.Beside(0, right), heading), track) { Right = right };
    }

    /// <summary>The track of the lane on which an actor begins, and where on it that is.</summary>
    private (LaneTrack Track, double At) TrackOf(ScenarioActor actor, double at)
    {
        if (actor.Start.Lane == ScenarioLane.Ego)
        {
            return (_place.Track, at);
        }

        Vector3D place = _place.Track.PositionAt(at);
        MapLane lane =
            actor.Start.Lane switch
            {
                ScenarioLane.Oncoming => _place.OncomingAt(at)?.Lane,
                ScenarioLane.Left => _place.LaneAt(at)?.LeftNeighbour,
                _ => _place.LaneAt(at)?.RightNeighbour,
            }
            ?? throw new UnfitPlaceException(
                FormattableString.Invariant(
                    $"There is no {Named(actor.Start.Lane)} lane {at:0} m ahead of the ego, where '{actor.Id}' begins."
                )
            );
        return (LaneTracks.Of(lane, LanePoint.Of(lane, place).Along), 0);
    }

    private static string Named(ScenarioLane lane) =>
        lane switch
        {
            ScenarioLane.Left => "left",
            ScenarioLane.Right => "right",
            _ => "oncoming",
        };

    private BoundActor Beside(ScenarioActor actor, int index, double at, double right)
    {
        Within(actor, at);
        LaneTrack track = _place.Track.Shifted(at);
        double offset = right + actor.Start.MetresRight;
        double heading = HeadingOf(track.DirectionAt(0)) + actor.Start.HeadingDegrees;
        bool isAgainst = Math.Cos(actor.Start.HeadingDegrees * Math.PI / 180) < -0.5;
        return new BoundActor(actor, Spawned(actor, index)(track.Beside(0, offset), heading), isAgainst ? track.Reversed() : track)
        {
            Right = isAgainst ? -offset : offset,
        };
    }

    private BoundActor AtCrossing(ScenarioActor actor, int index)
    {
        const double beyond = 1.5;
        (double from, double to) =
            _scenario.Place.Crossing ?? throw new UnfitPlaceException($"'{actor.Id}' begins at a crossing, which place does not require.");
        PlacedCrossing crossing = PlaceNeeds.CrossingOf(_place, from, to)!.Value;
        double right = actor.Start.Side < 0 ? crossing.Left - beyond : crossing.Right + beyond;
        return Beside(actor, index, crossing.At, right);
    }

    private BoundActor AtPoint(ScenarioActor actor, int index)
    {
        Vector2D point = actor.Start.Point;
        var ground = new Vector3D(point.X, point.Y, _place.Track.PositionAt(0).Z);
        Vector3D forward = Axes.FromHeading(actor.Start.HeadingDegrees).Forward;
        LaneTrack track = _place.Map.Index.At(ground, forward) is { } lane
            ? LaneTracks.Of(lane, LanePoint.Of(lane, ground).Along)
            : new LaneTrack([ground, ground + (forward * LaneTracks.Ahead)]);
        (double at, double right) = track.Locate(ground);
        ground = ground with { Z = track.PositionAt(at).Z };
        return new BoundActor(actor, Spawned(actor, index)(ground, actor.Start.HeadingDegrees), track.Shifted(at)) { Right = right };
    }

    private void Within(ScenarioActor actor, double at)
    {
        if (at < _place.Track.From || at > _place.Track.To)
        {
            throw new UnfitPlaceException(
                FormattableString.Invariant(
                    $"The road does not lead {Math.Abs(at):0} m {(at < 0 ? "back" : "ahead")} of the ego, where '{actor.Id}' begins."
                )
            );
        }
    }

    private Func<Vector3D, double, StageActor> Spawned(ScenarioActor actor, int index) =>
        (ground, heading) =>
            new StageActor(
                (StageKind)Enum.Parse(typeof(StageKind), actor.Type.ToString()),
                actor.Model,
                ground,
                heading,
                actor.Speed ?? _scenario.Ego.Speed,
                unchecked((_seed * 31) + (index * 7)) & int.MaxValue
            );

    private static double HeadingOf(Vector3D direction) => PathFollower.HeadingOf(new Vector2D(direction.X, direction.Y));
}
