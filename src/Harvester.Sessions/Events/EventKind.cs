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

    /// <summary>A vehicle came from the lane beside into that of another, closely ahead of it. One of both is the ego.</summary>
    CutIn,

    /// <summary>A vehicle drove past its stop line at a red light.</summary>
    RedLightRun,

    /// <summary>A vehicle drove past its stop line at a stop sign without having stopped.</summary>
    StopSignRun,

    /// <summary>A vehicle drives beside the road.</summary>
    OffRoad,

    /// <summary>A vehicle drives on a lane of the other direction.</summary>
    WrongWay,
}
