namespace Harvester.Sessions.Plans;

/// <summary>The instance masks of a plan's sessions.</summary>
public enum PlanMasks
{
    /// <summary>None.</summary>
    Off,

    /// <summary>By rays.</summary>
    Rays,

    /// <summary>By photographs of the frozen game.</summary>
    Coded,
}
