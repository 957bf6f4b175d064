using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>Turns the actions of a scenario into orders for a stage.</summary>
/// <param name="bound">The scenario at its place.</param>
/// <param name="stage">The stage.</param>
internal sealed class ActionOrders(BoundScenario bound, IStage stage)
{
    /// <summary>Shortest way on which a change of lanes is driven, metres.</summary>
    private const double ShortestChange = 8;

    /// <summary>A vehicle that stops at a line stands this far before it, metres from its origin.</summary>
    private const double BeforeLine = 4;

    /// <summary>Lets an actor move as at the beginning: along its lane, or not at all.</summary>
    public void Begin(StagedActor actor)
    {
        double speed = actor.Bound.Spawn.Speed;
        if (speed > 0)
        {
            KeepLane(actor, speed, new ScenarioAction(ScenarioActionKind.KeepLane), ignoresLights: true);
        }
    }

    /// <summary>Gives the order for an action.</summary>
    public void Give(StagedActor actor, ScenarioAction action, SceneView view)
    {
        double speed = action.Speed ?? actor.Speed;
        switch (action.Kind)
        {
            case ScenarioActionKind.KeepLane:
                KeepLane(actor, speed, action, ignoresLights: false);
                break;
            case ScenarioActionKind.RunJunction:
                KeepLane(actor, speed, action, ignoresLights: true);
                break;
            case ScenarioActionKind.ChangeLane:
                stage.SetIndicators(actor.Handle, action.Side < 0 ? StageIndicators.Left : StageIndicators.Right);
                MoveOver(actor, BesideOf(actor, action.Side), 0, speed, action);
                break;
            case ScenarioActionKind.CutIn:
            {
                LaneTrack track = bound.Place.Track;
                (double egoAt, double offset) = track.Locate(actor.State!.Pose.Position);
                stage.SetIndicators(actor.Handle, offset > 0 ? StageIndicators.Left : StageIndicators.Right);

                // Who comes on drives against the ego's lane.
                bool comesOn = actor.Track.DirectionAt(actor.At).Dot(track.DirectionAt(egoAt)) < 0;
                MoveOver(actor, comesOn ? track.Reversed() : track, 0, speed, action);
                break;
            }

            case ScenarioActionKind.PullOut:
                stage.SetIndicators(actor.Handle, action.Side < 0 ? StageIndicators.Left : StageIndicators.Right);
                MoveOver(actor, actor.Track, 0, speed, action);
                break;
            case ScenarioActionKind.Park:
                stage.SetIndicators(actor.Handle, action.Side < 0 ? StageIndicators.Left : StageIndicators.Right);
                Park(actor, speed, action, view);
                break;
            case ScenarioActionKind.Brake:
                stage.SetSpeed(actor.Handle, action.Speed ?? 0, action.Acceleration);
                break;
            case ScenarioActionKind.BreakDown:
                stage.SetSpeed(actor.Handle, 0, action.Acceleration);
                stage.SetIndicators(actor.Handle, StageIndicators.Hazard);
                break;
            case ScenarioActionKind.StopAtLine:
                Follow(
                    actor,
                    actor.Track.Path(actor.At, Math.Max(actor.At + 0.5, (actor.Bound.Line ?? actor.At) - BeforeLine)),
                    speed,
                    action
                );
                break;
            case ScenarioActionKind.Cross:
                Cross(actor, speed, action);
                break;
            case ScenarioActionKind.Reverse:
            {
                LaneTrack back = actor.Track.Reversed();
                double at = back.Locate(actor.State!.Pose.Position).At;
                double right = -actor.Right;
                Follow(actor, back.Path(at, at + action.Metres, _ => right), action.Speed ?? 2, action, isBackwards: true);
                break;
            }

            case ScenarioActionKind.OpenDoor:
                stage.SetDoor(actor.Handle, action.Side, isOpen: true);
                break;
            case ScenarioActionKind.FollowPath:
                Follow(actor, [.. action.Points.Select(point => WorldOf(point, action.IsWorld))], speed, action);
                break;
            default:
                break;
        }
    }

    /// <summary>Goes on with an action that needs an order in every tick.</summary>
    public void Continue(StagedActor actor, ScenarioAction action, double seconds)
    {
        if (action.Kind == ScenarioActionKind.SpeedProfile)
        {
            stage.SetSpeed(actor.Handle, SpeedIn(action.Profile, seconds), action.Acceleration);
        }
    }

    /// <summary>Whether an action is done.</summary>
    /// <param name="actor">The actor.</param>
    /// <param name="action">The action.</param>
    /// <param name="seconds">Seconds since it began.</param>
    public static bool IsDone(StagedActor actor, ScenarioAction action, double seconds)
    {
        const double nearly = 0.1;
        const double settled = 0.3;
        return actor.State is not { } state
            || action.Kind switch
            {
                ScenarioActionKind.KeepLane => action.Speed is not { } speed || Math.Abs(actor.Speed - speed) < nearly,
                ScenarioActionKind.Brake => actor.Speed < (action.Speed ?? 0) + nearly,
                ScenarioActionKind.BreakDown or ScenarioActionKind.StopAtLine => actor.Speed < nearly,
                ScenarioActionKind.ChangeLane or ScenarioActionKind.CutIn or ScenarioActionKind.PullOut => seconds > action.Seconds / 2
                    && Math.Abs(actor.Right) < settled,
                ScenarioActionKind.RunJunction => actor.At > (actor.Bound.Line ?? 0) + 15,
                ScenarioActionKind.OpenDoor => true,
                ScenarioActionKind.SpeedProfile => seconds > action.Profile[action.Profile.Count - 1].Seconds,
                _ => state.IsAtEnd && seconds > nearly,
            };
    }

    /// <summary>What follows an action that is done.</summary>
    public void End(StagedActor actor, ScenarioAction action)
    {
        if (
            action.Kind
            is ScenarioActionKind.ChangeLane
                or ScenarioActionKind.CutIn
                or ScenarioActionKind.PullOut
                or ScenarioActionKind.Park
        )
        {
            stage.SetIndicators(actor.Handle, StageIndicators.Off);
        }
    }

    private static double SpeedIn(IReadOnlyList<(double Seconds, double Speed)> profile, double seconds)
    {
        int next = 0;
        while (next < profile.Count && profile[next].Seconds <= seconds)
        {
            next++;
        }

        if (next == 0 || next == profile.Count)
        {
            return profile[Math.Min(next, profile.Count - 1)].Speed;
        }

        (double from, double slow) = profile[next - 1];
        (double to, double fast) = profile[next];
        return slow + ((fast - slow) * (seconds - from) / (to - from));
    }

    private void KeepLane(StagedActor actor, double speed, ScenarioAction action, bool ignoresLights)
    {
        double right = actor.State is null ? actor.Bound.Right : actor.Right;
        Follow(actor, actor.Track.Path(actor.At, actor.Track.To, _ => right), speed, action, ignoresLights: ignoresLights);
    }

    /// <summary>Moves sideways from where the actor is to an offset from a track, and goes on along that.</summary>
    private void MoveOver(StagedActor actor, LaneTrack track, double right, double speed, ScenarioAction action, double? metresAfter = null)
    {
        actor.TakeTrack(track);
        double from = actor.At;
        double before = actor.Right;
        double length = Math.Max(ShortestChange, Math.Max(actor.Speed, speed) * action.Seconds);
        double end = Math.Min(track.To, metresAfter is { } metres ? from + length + metres : double.PositiveInfinity);
        Follow(actor, track.Path(from, end, at => before + ((right - before) * Eased((at - from) / length))), speed, action);
    }

    private void Park(StagedActor actor, double speed, ScenarioAction action, SceneView view)
    {
        double at = bound.Place.Track.Locate(actor.State!.Pose.Position, view.EgoAt).At;
        double right = RoadsidePlaces.OffsetOf(bound.Place, at, action.Side, ScenarioStrip.Parking) ?? (action.Side * 4);
        const double rollOut = 6;
        MoveOver(actor, bound.Place.Track, right, Math.Max(2, speed), action, rollOut);
    }

    /// <summary>The lane beside the one along which an actor drives; against the traffic where there is no other.</summary>
    private LaneTrack BesideOf(StagedActor actor, int side)
    {
        Vector3D place = actor.Track.PositionAt(actor.At);
        Vector3D direction = actor.Track.DirectionAt(actor.At);
        MapLane? lane = bound.Place.Map.Index.At(place, direction);
        if (lane is null && bound.Place.Map.Index.At(place, -direction) is { } against)
        {
            // It drives against the traffic of its lane: what is on its right is on the left of that.
            MapLane? other =
                side > 0
                    ? bound.Place.OncomingAt(bound.Place.Track.Locate(place).At)?.Lane ?? against.Oncoming ?? against.LeftNeighbour
                    : against.RightNeighbour;
            return other is null ? actor.Track : Through(other, place, direction);
        }

        MapLane? next = side < 0 ? lane?.LeftNeighbour ?? lane?.Oncoming : lane?.RightNeighbour;
        return next is null ? actor.Track : Through(next, place, direction);
    }

    private static LaneTrack Through(MapLane lane, Vector3D place, Vector3D direction)
    {
        LaneTrack track = LaneTracks.Of(lane, LanePoint.Of(lane, place).Along);
        return track.DirectionAt(0).Dot(direction) < 0 ? track.Reversed() : track;
    }

    private void Cross(StagedActor actor, double speed, ScenarioAction action)
    {
        Vector3D place = actor.State!.Pose.Position;
        (double at, _) = bound.Place.Track.Locate(place);
        Vector3D forward = bound.Place.Track.DirectionAt(at);
        double turn = action.Degrees * Math.PI / 180;
        var way = new Vector3D(
            (forward.X * Math.Cos(turn)) - (forward.Y * Math.Sin(turn)),
            (forward.X * Math.Sin(turn)) + (forward.Y * Math.Cos(turn)),
            0
        );
        Vector3D ground = place with { Z = bound.Place.Track.PositionAt(at).Z };
        Follow(actor, [ground, ground + (way * action.Metres)], speed, action);
    }

    private Vector3D WorldOf(Vector2D point, bool isWorld)
    {
        if (!isWorld)
        {
            return bound.Place.Track.Beside(point.X, point.Y);
        }

        var place = new Vector3D(point.X, point.Y, 0);
        return place with { Z = bound.Place.Track.PositionAt(bound.Place.Track.Locate(place).At).Z };
    }

    private void Follow(
        StagedActor actor,
        IReadOnlyList<Vector3D> path,
        double speed,
        ScenarioAction action,
        bool isBackwards = false,
        bool ignoresLights = false
    ) =>
        stage.Follow(
            actor.Handle,
            new StageOrder(path, speed, action.Acceleration)
            {
                IsBackwards = isBackwards,
                IgnoresLights = ignoresLights,
                IgnoresOthers = actor.Bound.Actor.IgnoresOthers,
            }
        );

    /// <summary>0 before 0 and 1 past 1, without jumps of speed or acceleration between: 10 u³ - 15 u⁴ + 6 u⁵.</summary>
    private static double Eased(double fraction)
    {
        double u = Math.Max(0, Math.Min(1, fraction));
        return u * u * u * (10 + (u * ((6 * u) - 15)));
    }
}
