using System.Buffers.Binary;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;

namespace Harvester.TestSupport;

/// <summary>A client written from docs/bridge.md alone.</summary>
internal sealed class SocketClient : IDisposable
{
    /// <summary>What a client says first.</summary>
    public const string Hello = """{"type":"hello","version":1}""";

    private readonly TcpClient _connection = new();

    /// <param name="server">The game.</param>
    /// <param name="hello">What is sent first; null for nothing.</param>
    public SocketClient(IPEndPoint server, string? hello = Hello)
    {
        _connection.Connect(server);
        _connection.NoDelay = true;
        _connection.ReceiveTimeout = 30_000;
        Stream = _connection.GetStream();
        if (hello is not null)
        {
            Send(hello);
        }
    }

    public NetworkStream Stream { get; }

    /// <summary>The client's own port.</summary>
    public int LocalPort => ((IPEndPoint)_connection.Client.LocalEndPoint!).Port;

    public void Send(string header)
    {
        byte[] text = Encoding.UTF8.GetBytes(header);
        byte[] lengths = new byte[8];
        BinaryPrimitives.WriteInt32BigEndian(lengths, text.Length);
        Stream.Write(lengths);
        Stream.Write(text);
    }

    /// <summary>Writes bytes as they are.</summary>
    /// <returns>False where the other side was quicker to cut the connection off.</returns>
    public bool TryWrite(ReadOnlySpan<byte> bytes)
    {
        try
        {
            Stream.Write(bytes);
            return true;
        }
        catch (IOException)
        {
            return false;
        }
    }

    /// <summary>The next message of the game but its hello.</summary>
    public (JsonElement Header, byte[] Payload) Receive()
    {
        (JsonElement Header, byte[] Payload) message = ReceiveAny();
        return message.Header.GetProperty("type").GetString() == "hello" ? ReceiveAny() : message;
    }

    /// <summary>The next message of the game.</summary>
    public (JsonElement Header, byte[] Payload) ReceiveAny()
    {
        byte[] lengths = new byte[8];
        Stream.ReadExactly(lengths);
        byte[] header = new byte[BinaryPrimitives.ReadInt32BigEndian(lengths)];
        byte[] payload = new byte[BinaryPrimitives.ReadInt32BigEndian(lengths.AsSpan(4))];
        Stream.ReadExactly(header);
        Stream.ReadExactly(payload);
        return (JsonDocument.Parse(header).RootElement, payload);
    }

    /// <summary>Ends this side of the connection, and gives all that came until the other side's end.</summary>
    public string SayNoMore()
    {
        _connection.Client.Shutdown(SocketShutdown.Send);
        using var rest = new MemoryStream();
        try
        {
            Stream.CopyTo(rest);
        }
        catch (IOException e) when (e.InnerException is SocketException { SocketErrorCode: SocketError.ConnectionReset })
        {
            // Cut off with something unread.
        }

        return Encoding.UTF8.GetString(rest.ToArray());
    }

    public bool IsCutOff()
    {
        try
        {
            byte[] rest = new byte[4096];
            while (Stream.Read(rest) > 0) { }

            return true;
        }
        catch (IOException e) when (e.InnerException is SocketException { SocketErrorCode: SocketError.ConnectionReset })
        {
            return true;
        }
    }

    /// <summary>Ends as a process does that is killed with something unread.</summary>
    public void Kill()
    {
        _connection.LingerState = new LingerOption(true, 0);
        _connection.Close();
    }

    public void Dispose() => _connection.Dispose();
}
