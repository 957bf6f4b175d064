using System.Net;
using Harvester.Driving.Bridge;

namespace Harvester.Runs.Driving;

/// <summary>The bridge of a drive, and the side of it that this process runs.</summary>
/// <param name="Kind">The bridge.</param>
/// <param name="Role">The side or sides that this process runs.</param>
/// <param name="Folder">The shared folder of a folder bridge.</param>
/// <param name="At">Address on which a socket bridge listens, or to which the client connects; null for the default.</param>
/// <param name="Token">Secret that a client sends; null for none.</param>
/// <param name="Patience">Real time that one side waits for the other.</param>
public sealed record BridgePlan(BridgeName Kind, DriveRole Role, string Folder, IPEndPoint? At, string? Token, TimeSpan Patience)
{
    /// <summary>Default address of a game.</summary>
    public static IPEndPoint DefaultAddress { get; } = new(IPAddress.Loopback, SocketBridgeOptions.DefaultPort);

    /// <summary>The folder or address, for messages.</summary>
    public string Place => Kind == BridgeName.Folder ? Folder : (At ?? DefaultAddress).ToString();
}
