namespace Harvester.Sessions.Scenes;

/// <summary>What the driver of the ego is doing.</summary>
public enum Manoeuvre
{
    /// <summary>Keeps to the middle of its lane.</summary>
    KeepLane,

    /// <summary>Keeps its distance from a vehicle ahead in its lane.</summary>
    Follow,

    /// <summary>Wanders from side to side within its lane.</summary>
    Wander,

    /// <summary>Drifts to the side, towards a marking or onto it.</summary>
    Drift,

    /// <summary>Steers back into its lane after a drift or a lane change that was broken off.</summary>
    Recover,

    /// <summary>Changes to the lane on the left.</summary>
    LaneChangeLeft,

    /// <summary>Changes to the lane on the right.</summary>
    LaneChangeRight,

    /// <summary>Passes a slower vehicle, in the lane to the left of it.</summary>
    Overtake,

    /// <summary>Stands.</summary>
    Stop,
}
