using Harvester.Geometry;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>A scenario at a place: where everybody begins, and along which lines they go.</summary>
/// <param name="Scenario">The scenario.</param>
/// <param name="Place">The place.</param>
/// <param name="Actors">The actors, in the order of the scenario.</param>
public sealed record BoundScenario(Scenario Scenario, StagePlace Place, IReadOnlyList<BoundActor> Actors)
{
    /// <summary>
    /// The seconds after the beginning in which the light before the ego must be green, so that it comes to the junction at its speed; null
    /// if it has no light ahead.
    /// </summary>
    public (double From, double To)? Green =>
        Place.Junction is { HasLight: true } junction
            ? (Math.Max(0, (junction.Entry / Scenario.Ego.Speed) - 4), (junction.Entry / Scenario.Ego.Speed) + 1)
            : null;

    /// <summary>Where the ego begins, on the ground, metres, world.</summary>
    public Vector3D Ego => Place.Track.PositionAt(0);
}
