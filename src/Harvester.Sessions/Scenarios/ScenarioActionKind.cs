namespace Harvester.Sessions.Scenarios;

/// <summary>What an actor can do.</summary>
public enum ScenarioActionKind
{
    /// <summary>Drives along its lane at a speed.</summary>
    KeepLane,

    /// <summary>Changes to the lane beside its own.</summary>
    ChangeLane,

    /// <summary>Changes into the lane of the ego.</summary>
    CutIn,

    /// <summary>Brakes to a speed.</summary>
    Brake,

    /// <summary>Comes to a stop and stays there, with its hazard lights on.</summary>
    BreakDown,

    /// <summary>Walks or drives straight in a direction.</summary>
    Cross,

    /// <summary>Drives through the junction, whatever the light and the signs say.</summary>
    RunJunction,

    /// <summary>Stops where its lane ends at the junction.</summary>
    StopAtLine,

    /// <summary>Drives from the roadside into a lane.</summary>
    PullOut,

    /// <summary>Drives from its lane to the roadside and stops.</summary>
    Park,

    /// <summary>Drives backwards.</summary>
    Reverse,

    /// <summary>Opens a door.</summary>
    OpenDoor,

    /// <summary>Drives at speeds that change with time.</summary>
    SpeedProfile,

    /// <summary>Follows points.</summary>
    FollowPath,
}
