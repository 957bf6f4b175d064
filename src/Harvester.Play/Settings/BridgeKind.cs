namespace Harvester.Play.Settings;

/// <summary>Over what a client drives.</summary>
public enum BridgeKind
{
    /// <summary>Over nothing: nobody drives.</summary>
    Off,

    /// <summary>Over a socket.</summary>
    Socket,

    /// <summary>Over a shared folder.</summary>
    Folder,
}
