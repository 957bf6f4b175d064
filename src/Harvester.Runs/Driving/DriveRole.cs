namespace Harvester.Runs.Driving;

/// <summary>The side or sides of a bridge that this process runs.</summary>
public enum DriveRole
{
    /// <summary>Game and controller, in lock-step.</summary>
    Both,

    /// <summary>The simulated game, for a client in another process.</summary>
    Game,

    /// <summary>The controller, for a game in another process.</summary>
    Client,
}
