namespace Harvester.Runs.Supervising;

/// <summary>How a supervised program ended.</summary>
public enum SupervisorEnd
{
    /// <summary>It has finished.</summary>
    Finished,

    /// <summary>It has finished, but skipped some of its trials.</summary>
    Incomplete,

    /// <summary>It was restarted too often without a new frame.</summary>
    GivenUp,

    /// <summary>The supervision was cancelled.</summary>
    Cancelled,
}
