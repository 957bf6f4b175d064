using System.Buffers.Binary;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Runs.Clients;

/// <summary>The client's side of a socket bridge.</summary>
public sealed class SocketLink : IBridgeLink
{
    private const int MaxMessageLength = 64 << 20;

    private static readonly JsonSerializerOptions WithoutNull = new() { DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull };

    private readonly TcpClient _connection = new() { NoDelay = true };
    private readonly NetworkStream _stream;
    private bool _isGreeted;

    /// <summary>Connects to a game.</summary>
    /// <param name="host">Name or address of the game's machine.</param>
    /// <param name="port">Port of the game.</param>
    /// <param name="token">The game's secret; null for none.</param>
    /// <param name="patience">Time to wait for an answer, and for the rest of a message.</param>
    /// <exception cref="IOException">The connection fails.</exception>
    public SocketLink(string host, int port, string? token, TimeSpan patience)
    {
        try
        {
            Connect(host, port, patience);
            _stream = _connection.GetStream();
            _stream.ReadTimeout = _stream.WriteTimeout = (int)patience.TotalMilliseconds;
            Write(
                new
                {
                    type = BridgeProtocol.HelloType,
                    version = BridgeProtocol.Version,
                    token,
                }
            );
            AskForFrame();
        }
        catch
        {
            _connection.Dispose();
            throw;
        }
    }

    /// <inheritdoc/>
    public bool MayLose => false;

    /// <inheritdoc/>
    public ClientFrame? Receive(TimeSpan patience)
    {
        if (!_connection.Client.Poll(patience, SelectMode.SelectRead))
        {
            return null;
        }

        if (!_isGreeted)
        {
            TakeHello(Encoding.UTF8.GetString(ReadHeader()));
            return null;
        }

        // Of the messages that have arrived, the last one counts: the newest frame, or the reason why the game closes the bridge.
        byte[] newest = ReadHeader();
        while (_connection.Available > 0)
        {
            newest = ReadHeader();
        }

        try
        {
            return FrameOf(HeaderFields.Parse(Encoding.UTF8.GetString(newest)));
        }
        catch (BridgeException e)
        {
            throw new IOException($"The game sent an invalid frame: {e.Message}", e);
        }
    }

    /// <inheritdoc/>
    public void Send(DrivingControls controls, long frame) =>
        Write(
            new
            {
                type = "controls",
                steering = controls.Steering,
                throttle = controls.Throttle,
                brake = controls.Brake,
                frame,
            }
        );

    /// <inheritdoc/>
    public void AskForFrame() => Write(new { type = "requestFrame" });

    /// <inheritdoc/>
    public void Step(double seconds) => Write(new { type = "step", seconds });

    /// <inheritdoc/>
    public void Dispose() => _connection.Dispose();

    private void TakeHello(string header)
    {
        try
        {
            CheckError(HeaderFields.Parse(header));
            if (BridgeProtocol.ProblemOfGame(header) is { } problem)
            {
                throw new IOException($"Cannot drive over this bridge: {problem} Use programs of the same version.");
            }

            _isGreeted = true;
        }
        catch (BridgeException e)
        {
            throw new IOException($"The game sent an invalid hello: {e.Message}", e);
        }
    }

    private static void CheckError(HeaderFields header)
    {
        if (header.Text("type") == "error")
        {
            throw new IOException($"The game has closed the bridge: {header.Text("reason")}");
        }
    }

    private static ClientFrame FrameOf(HeaderFields header)
    {
        CheckError(header);
        double[] torcs = header.Numbers("torcsEquivalent", IndicatorTable.All.Count);
        double[] metres = header.Numbers("indicators", IndicatorTable.All.Count);
        double[] position = header.Numbers("position", 3);
        LaneIndicators indicators = ClientIndicators.Of(torcs);
        DrivingState seen = new(
            ClientIndicators.InMetres(indicators, ClientIndicators.SectionOf(torcs, metres), angleAhead: metres[0]),
            indicators,
            header.Boolean("fast"),
            header.Number("speedMetresPerSecond")
        )
        {
            HeadingRadians = Angles.ToRadians(header.Number("headingDegrees")),
        };
        return new ClientFrame(
            (long)header.Number("frame"),
            header.Number("timeSeconds"),
            seen,
            new Vector3D(position[0], position[1], position[2])
        );
    }

    private void Connect(string host, int port, TimeSpan patience)
    {
        try
        {
            if (!_connection.ConnectAsync(host, port).Wait(patience))
            {
                throw new IOException(
                    FormattableString.Invariant($"Cannot connect to {host}:{port}: no answer for {patience.TotalSeconds} s.")
                );
            }
        }
        catch (AggregateException e) when (e.InnerException is SocketException fault)
        {
            throw new IOException($"Cannot connect to {host}:{port}: {fault.Message.TrimEnd('.')}. Start the game's side first.", fault);
        }
    }

    private void Write<T>(T message)
    {
        byte[] header = JsonSerializer.SerializeToUtf8Bytes(message, WithoutNull);
        byte[] whole = new byte[8 + header.Length];
        BinaryPrimitives.WriteInt32BigEndian(whole, header.Length);
        header.CopyTo(whole, 8);
        try
        {
            _stream.Write(whole);
        }
        catch (IOException e) when (IsClosing(e))
        {
            // The last message, with the reason for closing the bridge, may still be unread; the next request for a frame reads it.
            return;
        }
    }

    /// <summary>The header of a message; its image is skipped.</summary>
    private byte[] ReadHeader()
    {
        byte[] lengths = new byte[8];
        ReadFirst(lengths);
        byte[] header = Read(BinaryPrimitives.ReadInt32BigEndian(lengths));
        Read(BinaryPrimitives.ReadInt32BigEndian(lengths.AsSpan(4)));
        return header;
    }

    private void ReadFirst(byte[] bytes)
    {
        try
        {
            if (_stream.Read(bytes, 0, 1) == 0)
            {
                throw new BridgeEndedException();
            }
        }
        catch (IOException e) when (IsClosing(e))
        {
            throw new BridgeEndedException();
        }

        Fill(bytes.AsSpan(1));
    }

    private static bool IsClosing(IOException fault) =>
        fault.InnerException
            is SocketException { SocketErrorCode: SocketError.ConnectionReset or SocketError.ConnectionAborted or SocketError.Shutdown };

    private byte[] Read(int length)
    {
        if (length is < 0 or > MaxMessageLength)
        {
            throw new IOException($"The game announced a message of {length} bytes, over the limit.");
        }

        byte[] bytes = new byte[length];
        Fill(bytes);
        return bytes;
    }

    private void Fill(Span<byte> bytes)
    {
        try
        {
            _stream.ReadExactly(bytes);
        }
        catch (IOException e)
        {
            throw new IOException($"The bridge closed in the middle of a message: {e.Message}", e);
        }
    }
}
