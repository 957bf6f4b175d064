namespace Harvester.Runs.Driving;

/// <summary>The connection between game and controller.</summary>
public enum BridgeName
{
    /// <summary>None: both run in one process, and no image is drawn.</summary>
    Direct,

    /// <summary>A shared folder.</summary>
    Folder,

    /// <summary>A socket.</summary>
    Socket,
}
