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

    /// <summary>Another vehicle entered the lane of the ego shortly ahead of it.</summary>
    CutIn,

    /// <summary>A vehicle passed a stop line at a red light.</summary>
    RedLightRun,

    /// <summary>A vehicle passed a stop sign without having stopped.</summary>
    StopSignRun,

    /// <summary>The ego left its lanes.</summary>
    OffRoad,

    /// <summary>A vehicle drove against the direction of its lane.</summary>
    WrongWay,
}
