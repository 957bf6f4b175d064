namespace Harvester.Sessions.Plans;

/// <summary>How an attempt at a trial ended.</summary>
public enum TrialState
{
    /// <summary>Its session is complete.</summary>
    Done,

    /// <summary>It failed; it is repeated.</summary>
    Failed,

    /// <summary>It failed for the last time; the trial has no session.</summary>
    Skipped,
}
