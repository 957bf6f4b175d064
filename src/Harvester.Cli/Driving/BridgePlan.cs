using System;
using System.Net;
using Harvester.Driving.Bridge;

namespace Harvester.Cli.Driving;

/// <summary>Over what a drive goes, and which side of it this process is.</summary>
/// <param name="Kind">The bridge.</param>
/// <param name="Role">Which sides.</param>
/// <param name="Folder">The shared folder of a folder bridge.</param>
/// <param name="At">Where a socket bridge listens or is reached; null for a free port of this machine, or the usual one.</param>
/// <param name="Token">What a client shows; null for none.</param>
/// <param name="Patience">How long, on the clock, one side waits for the other.</param>
internal sealed record BridgePlan(BridgeName Kind, DriveRole Role, string Folder, IPEndPoint? At, string? Token, TimeSpan Patience)
{
    /// <summary>Where the game is found when nothing else is said.</summary>
    public static IPEndPoint UsualPlace { get; } = new(IPAddress.Loopback, SocketBridgeOptions.DefaultPort);

    /// <summary>Where the two sides meet, for people.</summary>
    public string Place => Kind == BridgeName.Folder ? Folder : (At ?? UsualPlace).ToString();
}
