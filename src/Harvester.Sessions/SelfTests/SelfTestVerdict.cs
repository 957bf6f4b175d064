namespace Harvester.Sessions.SelfTests;

/// <summary>What a check of the self-test found.</summary>
public enum SelfTestVerdict
{
    /// <summary>It works as labels need it.</summary>
    Good,

    /// <summary>It differs from an ideal game, and harvests allow for it.</summary>
    Note,

    /// <summary>It would spoil pictures or labels.</summary>
    Problem,

    /// <summary>It could not be tested; the sentence says why.</summary>
    Untested,
}
