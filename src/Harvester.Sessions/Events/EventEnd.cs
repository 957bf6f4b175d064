namespace Harvester.Sessions.Events;

/// <summary>Why an event ended. In files its name begins with a lower-case letter.</summary>
public enum EventEnd
{
    /// <summary>Its condition no longer held.</summary>
    Over,

    /// <summary>A near miss: the participants collided.</summary>
    Collision,

    /// <summary>A participant left the range that is read, vanished or was placed elsewhere.</summary>
    Vanished,

    /// <summary>The harvest ended.</summary>
    SessionEnd,
}
