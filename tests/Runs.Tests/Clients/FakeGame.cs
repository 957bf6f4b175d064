using System.Buffers.Binary;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Harvester.Runs.Tests.Clients;

/// <summary>The near end of a socket bridge, that says whatever a test has it say to the one client that connects.</summary>
internal sealed class FakeGame : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private TcpClient? _client;

    public FakeGame() => _listener.Start();

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>The game's first message; null for none.</summary>
    public string? Hello { get; init; } = """{"type":"hello","version":1}""";

    private NetworkStream Stream
    {
        get
        {
            if (_client is null)
            {
                _client = _listener.AcceptTcpClient();
                if (Hello is not null)
                {
                    _client.GetStream().Write(Message(Hello));
                }
            }

            return _client.GetStream();
        }
    }

    public static byte[] Frame(int number, double x = 0) =>
        Message(
            $$"""{"type":"frame","frame":{{number}},"timeSeconds":{{number / 10.0:0.0}},"speedMetresPerSecond":5,"position":[{{x}},0,0]"""
                + $$""","headingDegrees":0,"fast":true,"lanesKnown":true,"indicators":[-0.05,-7,3.5,7,75,75,-9.5,-2.7,2.7,9.5,75,75,75]"""
                + $$""","torcsEquivalent":[0,-7,3.5,7,75,75,-9.5,-2,2,9.5,75,75,75]}"""
        );

    public static byte[] Message(string header)
    {
        byte[] text = Encoding.UTF8.GetBytes(header);
        byte[] message = new byte[8 + text.Length];
        BinaryPrimitives.WriteInt32BigEndian(message, text.Length);
        text.CopyTo(message, 8);
        return message;
    }

    public void Say(byte[] message) => Stream.Write(message);

    /// <summary>The next message of the client.</summary>
    public string Receive()
    {
        byte[] lengths = new byte[8];
        Stream.ReadExactly(lengths);
        byte[] header = new byte[BinaryPrimitives.ReadInt32BigEndian(lengths)];
        Stream.ReadExactly(header);
        return Encoding.UTF8.GetString(header);
    }

    /// <summary>Closes the connection after all that was said has been sent.</summary>
    public void Close() => _client?.Dispose();

    public void Dispose()
    {
        Close();
        _listener.Dispose();
    }
}
