using System.IO;
using System.Net;
using System.Net.Sockets;
using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Driving;

/// <summary>Opens socket bridges where a command line says.</summary>
internal static class SocketBridges
{
    /// <summary>Listens.</summary>
    /// <exception cref="UsageException">Others can reach the address, and there is no token.</exception>
    /// <exception cref="IOException">The address or port cannot be had.</exception>
    public static SocketBridge Open(IPEndPoint at, string? token, ImageSize picture)
    {
        if (!IPAddress.IsLoopback(at.Address) && string.IsNullOrEmpty(token))
        {
            throw new UsageException($"{at.Address} is reachable from other machines; set a --token that clients must send.");
        }

        try
        {
            return new SocketBridge(new SocketBridgeOptions(at.Address, at.Port, token), picture);
        }
        catch (SocketException e)
        {
            throw new IOException($"Cannot listen on {at}: {e.Message}", e);
        }
    }
}
