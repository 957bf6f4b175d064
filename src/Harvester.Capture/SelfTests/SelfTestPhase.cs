namespace Harvester.Capture.SelfTests;

/// <summary>Where a self-test is.</summary>
public enum SelfTestPhase
{
    /// <summary>It is running.</summary>
    Running,

    /// <summary>It has ended, and the result is complete.</summary>
    Done,

    /// <summary>It was stopped before its end.</summary>
    Stopped,
}
