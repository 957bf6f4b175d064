using System.Net;
using System.Net.Sockets;
using Harvester.Driving.Bridge;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Faults;

namespace Harvester.Runs.Driving;

/// <summary>Opens socket bridges.</summary>
public static class SocketBridges
{
    /// <summary>Opens a bridge that listens on an address.</summary>
    /// <exception cref="UsageException">The address is reachable from other machines, and there is no token.</exception>
    /// <exception cref="IOException">The address or port is not available.</exception>
    public static SocketBridge Open(IPEndPoint at, string? token, ImageSize picture, bool canRestart = false)
    {
        if (!IPAddress.IsLoopback(at.Address) && string.IsNullOrEmpty(token))
        {
            throw new UsageException($"{at.Address} is reachable from other machines; set a --token that clients must send.");
        }

        try
        {
            return new SocketBridge(new SocketBridgeOptions(at.Address, at.Port, token) { CanRestart = canRestart }, picture);
        }
        catch (SocketException e)
        {
            throw new IOException($"Cannot listen on {at}: {e.Message}", e);
        }
    }
}
