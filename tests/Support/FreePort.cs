using System.Net;
using System.Net.Sockets;

namespace Harvester.TestSupport;

/// <summary>
/// A port that nobody listens at, below those that systems give to connections on their way out and to who asks for any: of the latter
/// another process, such as that of other tests, could take it before the one under test does.
/// </summary>
internal static class FreePort
{
    public static int Find()
    {
        while (true)
        {
            int port = Random.Shared.Next(20_000, 32_000);
            try
            {
                using var listener = new TcpListener(IPAddress.Loopback, port);
                listener.Start();
                return port;
            }
            catch (SocketException)
            {
                // Somebody listens there.
            }
        }
    }
}
