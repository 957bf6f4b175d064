using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Scenarios;

/// <summary>What a scenario sees of the world in a tick.</summary>
/// <param name="Bound">The scenario at its place.</param>
/// <param name="Seconds">Seconds since its beginning.</param>
/// <param name="Ego">The ego.</param>
/// <param name="EgoAt">Where the ego is on its track, metres from its start.</param>
/// <param name="Light">The light before the ego.</param>
internal sealed record SceneView(BoundScenario Bound, double Seconds, EgoState Ego, double EgoAt, LightState Light)
{
    /// <summary>Below this speed, m/s, arrival times are those at this speed.</summary>
    private const double Slowest = 0.5;

    /// <summary>Speed of the ego, m/s.</summary>
    public double EgoSpeed => Ego.Velocity.Length;

    /// <summary>Distance of the ego from the junction's entry, metres; infinite without one.</summary>
    public double ToJunction => Bound.Place.Junction is { } junction ? junction.Entry - EgoAt : double.PositiveInfinity;

    /// <summary>Seconds until the ego has driven a distance at its speed.</summary>
    public double SecondsFor(double metres) => metres / Math.Max(Slowest, EgoSpeed);

    /// <summary>How far an actor is ahead of the ego along the ego's track, metres.</summary>
    public double AheadOf(StagedActor actor) =>
        actor.State is { } state ? Bound.Place.Track.Locate(state.Pose.Position, EgoAt).At - EgoAt : double.PositiveInfinity;

    /// <summary>Distance of an actor from the ego, middle to middle, metres.</summary>
    public double DistanceTo(StagedActor actor) =>
        actor.State is { } state ? Level(state.Pose.Position - Ego.Pose.Position).Length : double.PositiveInfinity;

    /// <summary>
    /// Seconds until the ego and an actor meet: the room between them, along the line that joins their middles and without half of their
    /// lengths, over the speed at which they approach each other; infinite if they do not.
    /// </summary>
    public double TimeToCollision(StagedActor actor)
    {
        if (actor.State is not { } state)
        {
            return double.PositiveInfinity;
        }

        Vector3D apart = Level(state.Pose.Position - Ego.Pose.Position);
        double distance = apart.Length;
        double closing = distance > 0 ? Level(Ego.Velocity - state.Velocity).Dot(apart) / distance : 0;
        double room = distance - state.HalfLength - ((Ego.ModelMax.Y - Ego.ModelMin.Y) / 2);
        return closing > 0 ? Math.Max(0, room) / closing : double.PositiveInfinity;
    }

    /// <summary>
    /// Whether the ego's rectangle on the ground touches an actor's, with a margin for bodies that stop before they overlap.
    /// </summary>
    public bool IsTouching(StagedActor actor)
    {
        const double margin = 0.2;
        return actor.State is { } state
            && GroundRectangle
                .Of(Ego.Pose, (Ego.ModelMax.Y - Ego.ModelMin.Y) / 2, (Ego.ModelMax.X - Ego.ModelMin.X) / 2)
                .Grown(margin)
                .Overlaps(GroundRectangle.Of(state.Pose, state.HalfLength, state.HalfWidth));
    }

    private static Vector3D Level(Vector3D vector) => new(vector.X, vector.Y, 0);
}
