namespace Harvester.Sessions.Plans;

/// <summary>The state of a program that runs a plan.</summary>
public enum HeartbeatState
{
    /// <summary>It has begun, or goes to the place of a trial.</summary>
    Starting,

    /// <summary>It takes frames.</summary>
    Running,

    /// <summary>It has ended, and every trial has its session.</summary>
    Finished,

    /// <summary>It was stopped, or cannot go on; trials are left.</summary>
    Failed,

    /// <summary>It has ended, and nothing is left to do, but a trial was skipped and has no session.</summary>
    Incomplete,
}
