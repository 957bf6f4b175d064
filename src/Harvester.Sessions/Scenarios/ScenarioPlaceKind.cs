namespace Harvester.Sessions.Scenarios;

/// <summary>To what the start of an actor is related.</summary>
public enum ScenarioPlaceKind
{
    /// <summary>A lane, at a distance ahead of the ego.</summary>
    Lane,

    /// <summary>The side of the road, at a distance ahead of the ego.</summary>
    Roadside,

    /// <summary>The end of a pedestrian crossing ahead of the ego.</summary>
    Crossing,

    /// <summary>A road that comes into the junction ahead of the ego.</summary>
    Junction,

    /// <summary>A point of the world.</summary>
    Point,
}
