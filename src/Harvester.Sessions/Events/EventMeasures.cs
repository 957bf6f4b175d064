namespace Harvester.Sessions.Events;

/// <summary>The names of measures.</summary>
public static class EventMeasures
{
    /// <summary>Least time to collision of a near miss, seconds.</summary>
    public const string TimeToCollision = "timeToCollisionSeconds";

    /// <summary>Least post-encroachment time of a near miss, seconds.</summary>
    public const string PostEncroachment = "postEncroachmentSeconds";

    /// <summary>Greatest mean deceleration over the window, m/s².</summary>
    public const string Deceleration = "deceleration";

    /// <summary>Speed at the beginning of the window, m/s.</summary>
    public const string SpeedBefore = "speedBefore";

    /// <summary>Speed at the end of the window, m/s.</summary>
    public const string SpeedAfter = "speedAfter";
}
