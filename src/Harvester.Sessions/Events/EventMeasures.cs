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

    /// <summary>Distance along the lane between the rear of the one that cuts in and the front of the one behind, metres.</summary>
    public const string Gap = "gap";

    /// <summary>That distance divided by the speed of the one behind, seconds.</summary>
    public const string TimeGap = "timeGapSeconds";

    /// <summary>By how much the one behind is faster along the lane, m/s; negative if it is slower.</summary>
    public const string ClosingSpeed = "closingSpeed";

    /// <summary>Horizontal speed of the vehicle at the peak, m/s.</summary>
    public const string Speed = "speed";

    /// <summary>Time since the light became red, seconds.</summary>
    public const string Red = "redSeconds";

    /// <summary>Least horizontal speed before the stop line, m/s.</summary>
    public const string MinSpeed = "minSpeed";

    /// <summary>Distance from the nearest lane, metres.</summary>
    public const string FromRoad = "fromRoad";
}
