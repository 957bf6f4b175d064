namespace Harvester.Cli.Driving;

/// <summary>What lies between game and controller.</summary>
internal enum BridgeName
{
    /// <summary>Nothing: both are in one process, and no picture is drawn.</summary>
    Direct,

    /// <summary>A shared folder.</summary>
    Folder,

    /// <summary>A socket.</summary>
    Socket,
}
