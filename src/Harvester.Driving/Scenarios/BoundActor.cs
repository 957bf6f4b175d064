using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>An actor of a scenario at a place.</summary>
/// <param name="Actor">The actor.</param>
/// <param name="Spawn">What is put where.</param>
/// <param name="Track">The line along which it drives, in its direction.</param>
public sealed record BoundActor(ScenarioActor Actor, StageActor Spawn, LaneTrack Track)
{
    /// <summary>Where on its track the junction begins, metres; null if it comes to none.</summary>
    public double? Line { get; init; }

    /// <summary>Metres to the right of its track.</summary>
    public double Right { get; init; }

    /// <summary>Where it begins, on the ground, metres, world.</summary>
    public Vector3D Ground => Spawn.Ground;
}
