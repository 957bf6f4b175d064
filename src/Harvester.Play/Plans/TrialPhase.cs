namespace Harvester.Play.Plans;

/// <summary>What an attempt at a trial is doing.</summary>
public enum TrialPhase
{
    /// <summary>Waits until the player is alive and in control, and sits in a vehicle.</summary>
    Boarding,

    /// <summary>Waits until the place is loaded.</summary>
    Loading,

    /// <summary>Waits until the picture has settled under the new sky.</summary>
    Settling,

    /// <summary>Drives and takes frames.</summary>
    Driving,

    /// <summary>Waits until the session is written.</summary>
    Writing,

    /// <summary>It has ended.</summary>
    Over,
}
