using System.Net;

namespace Harvester.Driving.Bridge;

/// <summary>Where a socket bridge listens, and for which clients.</summary>
/// <param name="Address">Address to listen at. Any but a loopback address requires a token.</param>
/// <param name="Port">1 to 65,535, or 0 for any free port.</param>
/// <param name="Token">The token that the hello of a client must contain; null if none is required.</param>
public sealed record SocketBridgeOptions(IPAddress Address, int Port, string? Token)
{
    /// <summary>The default port.</summary>
    public const int DefaultPort = 4567;

    /// <summary>The loopback interface, no token.</summary>
    public static SocketBridgeOptions Loopback { get; } = new(IPAddress.Loopback, DefaultPort, null);

    /// <summary>Maximum time for a connection to send its hello; longer than 0, or Timeout.InfiniteTimeSpan.</summary>
    public TimeSpan HelloPatience { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Maximum time for the client to receive a frame before it is disconnected, and for which closing the bridge waits for that; 1 ms to
    /// 24 days.
    /// </summary>
    public TimeSpan SendPatience { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// Maximum number of connections that have not sent a hello yet; at least 1. The one that has waited longest makes room for another.
    /// </summary>
    public int MaxPending { get; init; } = 16;

    /// <summary>Whether the game can be restarted; a client that asks another for it is disconnected, with the reason.</summary>
    public bool CanRestart { get; init; }
}
