using System;
using System.Buffers.Binary;
using System.IO;
using System.Linq;
using System.Net.Sockets;
using System.Text.Json;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Peers;

/// <summary>The far end of a socket bridge.</summary>
public sealed class SocketLink : IPeerLink
{
    private const int LargestMessage = 64 << 20;

    private readonly TcpClient _client;
    private readonly NetworkStream _stream;

    /// <summary>Connects.</summary>
    /// <param name="host">Name or address of the game's machine.</param>
    /// <param name="port">Its port.</param>
    /// <param name="token">What it asks for; null for nothing.</param>
    /// <exception cref="IOException">Nobody listens there.</exception>
    public SocketLink(string host, int port, string? token)
    {
        try
        {
            _client = new TcpClient(host, port) { NoDelay = true };
        }
        catch (SocketException e)
        {
            throw new IOException($"No bridge is to be reached at {host}:{port}: {e.Message}", e);
        }

        _stream = _client.GetStream();
        if (token is not null)
        {
            Write(new { type = "hello", token });
        }

        Write(new { type = "requestFrame" });
    }

    /// <inheritdoc/>
    public PeerFrame? Receive(TimeSpan patience)
    {
        if (!_client.Client.Poll(patience, SelectMode.SelectRead))
        {
            return null;
        }

        byte[] lengths = Read(8);
        byte[] header = Read(BinaryPrimitives.ReadInt32BigEndian(lengths));
        Read(BinaryPrimitives.ReadInt32BigEndian(lengths.AsSpan(4)));
        using JsonDocument message = JsonDocument.Parse(header);
        JsonElement root = message.RootElement;
        if (root.GetProperty("type").GetString() == "error")
        {
            throw new IOException($"The bridge was closed: {root.GetProperty("reason").GetString()}");
        }

        double[] torcs = Numbers(root, "torcsEquivalent");
        LaneIndicators indicators = PeerIndicators.Of(torcs);
        return new PeerFrame(root.GetProperty("frame").GetInt64(), root.GetProperty("timeSeconds").GetDouble(), new DrivingState(
            TorcsEquivalent.InMetres(indicators, PeerIndicators.SectionOf(torcs, Numbers(root, "indicators"))),
            indicators,
            root.GetProperty("fast").GetBoolean(),
            root.GetProperty("speedMetresPerSecond").GetDouble())
        {
            HeadingRadians = Angles.ToRadians(root.GetProperty("headingDegrees").GetDouble()),
        });
    }

    /// <inheritdoc/>
    public void Send(DrivingControls controls, long frame) =>
        Write(new { type = "controls", steering = controls.Steering, throttle = controls.Throttle, brake = controls.Brake, frame });

    /// <inheritdoc/>
    public void Step(double seconds) => Write(new { type = "step", seconds });

    /// <inheritdoc/>
    public void Dispose() => _client.Dispose();

    private static double[] Numbers(JsonElement root, string name) => [.. root.GetProperty(name).EnumerateArray().Select(value => value.GetDouble())];

    private void Write<T>(T message)
    {
        byte[] header = JsonSerializer.SerializeToUtf8Bytes(message);
        byte[] whole = new byte[8 + header.Length];
        BinaryPrimitives.WriteInt32BigEndian(whole, header.Length);
        header.CopyTo(whole, 8);
        _stream.Write(whole);
    }

    private byte[] Read(int length)
    {
        if (length is < 0 or > LargestMessage)
        {
            throw new IOException($"The bridge announces a message of {length} bytes.");
        }

        byte[] bytes = new byte[length];
        _stream.ReadExactly(bytes);
        return bytes;
    }
}
