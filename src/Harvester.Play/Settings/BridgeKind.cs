namespace Harvester.Play.Settings;

/// <summary>The kind of bridge over which a client drives.</summary>
public enum BridgeKind
{
    /// <summary>No bridge.</summary>
    Off,

    /// <summary>A socket.</summary>
    Socket,

    /// <summary>A shared folder.</summary>
    Folder,
}
