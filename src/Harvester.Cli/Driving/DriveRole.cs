namespace Harvester.Cli.Driving;

/// <summary>Which sides of a bridge this process is.</summary>
internal enum DriveRole
{
    /// <summary>Game and controller, in lock-step.</summary>
    Both,

    /// <summary>The simulated game, for a client elsewhere.</summary>
    Game,

    /// <summary>The controller, for a game elsewhere.</summary>
    Client,
}
