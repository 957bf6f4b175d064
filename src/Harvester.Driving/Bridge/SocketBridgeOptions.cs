using System;
using System.Net;

namespace Harvester.Driving.Bridge;

/// <summary>Where a socket bridge listens, and to whom.</summary>
/// <param name="Address">Address to listen at. Anything but a loopback address asks for a token.</param>
/// <param name="Port">1 to 65,535, or 0 for any free one.</param>
/// <param name="Token">What a client must show in its first message; null for none.</param>
public sealed record SocketBridgeOptions(IPAddress Address, int Port, string? Token)
{
    /// <summary>The port when none is named.</summary>
    public const int DefaultPort = 4567;

    /// <summary>The loopback interface, no token.</summary>
    public static SocketBridgeOptions Loopback { get; } = new(IPAddress.Loopback, DefaultPort, null);

    /// <summary>How long a connection may take to show the token; longer than 0, or Timeout.InfiniteTimeSpan.</summary>
    public TimeSpan TokenPatience { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// How long the client may leave a frame untaken before it is cut off, and how long the end of the bridge waits for that; a millisecond
    /// to 24 days.
    /// </summary>
    public TimeSpan SendPatience { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// How many connections may be about to show the token at a time; at least 1. The one that has waited longest makes room for another.
    /// </summary>
    public int MaxPending { get; init; } = 16;
}
