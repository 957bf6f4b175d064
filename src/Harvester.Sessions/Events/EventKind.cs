namespace Harvester.Sessions.Events;

/// <summary>What happened in an event. In files its name begins with a lower-case letter. Definitions: docs/events.md.</summary>
public enum EventKind
{
    /// <summary>The footprints of two road users would have met soon, or crossed the same place shortly after each other.</summary>
    NearMiss,

    /// <summary>A vehicle slowed down hard.</summary>
    HardBraking,

    /// <summary>The footprints of two road users touched.</summary>
    Collision,
}
