using System.Buffers.Binary;
using System.Text;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Tests.Doubles;

namespace Harvester.Capture.Tests.Driving.Bridge;

/// <summary>A whole drive at the end of a real socket, with peers that mean ill or are broken.</summary>
public sealed class FuzzedDriveTests
{
    private static readonly string[] Good =
    [
        """{"type":"controls","steering":-0.25,"throttle":0.5,"brake":0.1,"frame":12}""",
        """{"type":"indicators","values":[0.1,-7,3.5,7,75,75,-9.5,-1.6,2.4,5.5,75,30,40],"frame":3}""",
        """{"type":"reset","position":[1,2,3],"headingDegrees":90}""",
        """{"type":"environment","weather":"rain","timeOfDay":"17:30"}""",
        """{"type":"pause","paused":true}""",
        """{"type":"step","seconds":0.1}""",
        """{"type":"requestFrame"}""",
    ];

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(typeof(DeepDrivingController))]
    [InlineData(typeof(StanleyController))]
    public void Ten_thousand_mutated_messages_never_end_the_drive_nor_move_the_wheel_beyond_its_range(Type controller)
    {
        var game = new FakeGame();
        var car = new FakeCar();
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, new DrivingOptions().Picture);
        using var session = new DrivingSession(
            new DrivingOptions { SettleTicks = 0 },
            game.Ports with { Car = car },
            bridge,
            () => controller == typeof(StanleyController) ? new StanleyController(new StanleyOptions()) : new DeepDrivingController());
        var random = new Random(13);
        int refused = 0;
        for (int i = 0; i < 10_000; i++)
        {
            // Each has a connection of its own, or the first bad one of a connection would be the last that is read.
            using (var peer = new SocketClient(bridge.EndPoint))
            {
                peer.Stream.Write(Mutated(random));
                refused += peer.SayNoMore().Contains("\"type\":\"error\"", StringComparison.Ordinal) ? 1 : 0;
            }

            session.Tick();
            game.Tick();
        }

        Assert.False(session.Status.IsOver, session.Status.Ending);
        Assert.InRange(refused, 1_000, 9_000);
        Assert.Contains(car.Driven, controls => controls != DrivingControls.Stop);
        Assert.All(car.Driven, controls => Assert.True(Math.Abs(controls.Steering) <= 1 && controls.Throttle is >= 0 and <= 1 && controls.Brake is >= 0 and <= 1));

        using var good = new SocketClient(bridge.EndPoint);
        good.Send("""{"type":"controls","steering":0.625,"throttle":0,"brake":0}""");
        Frames.Await(
            () =>
            {
                game.Tick();
                return session.Tick().Controls.Steering == 0.625;
            },
            "the good peer to drive");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Peers_that_trickle_their_bytes_are_cut_off_in_two_seconds_and_hold_nobody_up()
    {
        const string token = "open sesame";
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0, Token = token }, Frames.Size);
        SocketClient[] slow = [.. Enumerable.Range(0, 20).Select(_ => new SocketClient(bridge.EndPoint))];
        byte[] hello = Framed(Encoding.UTF8.GetBytes("{\"type\":\"hello\",\"token\":\"open sesame\"}"));
        using var good = new SocketClient(bridge.EndPoint);
        good.Send("{\"type\":\"hello\",\"token\":\"open sesame\"}");
        good.Send("""{"type":"requestFrame"}""");
        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));

        // A byte each 0.1 s would take more than four seconds for the whole; none of the reads waits for long.
        int sent = 0;
        for (; sent < hello.Length - 1 && slow.Any(peer => TryWrite(peer, hello[sent])); sent++)
        {
            Thread.Sleep(100);
        }

        Assert.True(sent < hello.Length - 1, "Some peer was listened to until its last byte but one.");
        Assert.All(slow, peer => Assert.True(peer.IsCutOff()));
        bridge.Publish(Frames.State(5), Frames.Picture(5));
        Assert.Equal(5, good.Receive().Header.GetProperty("frame").GetInt64());
        Assert.All(slow, peer => peer.Dispose());
    }

    [Theory]
    [InlineData(new byte[] { 0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0x80, 0, 0, 0, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0, 1, 0, 1, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0, 0, 0, 10, 0x7F, 0xFF, 0xFF, 0xFF })]
    [InlineData(new byte[] { 0, 0, 0, 10, 0xFF, 0xFF, 0xFF, 0xFF })]
    [InlineData(new byte[] { 0, 0, 0, 0, 0, 0, 0, 0 })]
    public void Lengths_that_no_peer_may_send_are_refused_before_anything_is_read(byte[] lengths)
    {
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, Frames.Size);
        using var peer = new SocketClient(bridge.EndPoint);
        peer.Stream.Write(lengths);

        Assert.Equal("error", peer.Receive().Header.GetProperty("type").GetString());
        Assert.True(peer.IsCutOff());
    }

    /// <summary>A good message with bytes changed, left out, said again or broken off, or with other lengths.</summary>
    private static byte[] Mutated(Random random)
    {
        List<byte> bytes = [.. Framed(Encoding.UTF8.GetBytes(Good[random.Next(Good.Length)]))];
        switch (random.Next(8))
        {
            case 0:
                bytes[random.Next(8)] ^= (byte)(1 << random.Next(8));
                break;
            case 1:
                bytes.RemoveRange(random.Next(bytes.Count), 1);
                break;
            case 2:
                bytes.InsertRange(random.Next(bytes.Count), bytes.Take(random.Next(1, 20)).ToArray());
                break;
            case 3 or 4:
                // Digits become other digits, exponents and signs, so that numbers grow beyond all bounds.
                const string numeric = "0123456789eE+-.";
                int[] digits = [.. Enumerable.Range(8, bytes.Count - 8).Where(at => char.IsDigit((char)bytes[at]))];
                for (int change = 0; change < 3 && digits.Length > 0; change++)
                {
                    bytes[digits[random.Next(digits.Length)]] = (byte)numeric[random.Next(numeric.Length)];
                }

                break;
            case 5 or 6:
                for (int change = random.Next(1, 4); change > 0; change--)
                {
                    bytes[random.Next(8, bytes.Count)] = (byte)random.Next(256);
                }

                break;
            default:
                break;
        }

        return [.. bytes];
    }

    private static byte[] Framed(byte[] header)
    {
        byte[] bytes = new byte[8 + header.Length];
        BinaryPrimitives.WriteInt32BigEndian(bytes, header.Length);
        header.CopyTo(bytes, 8);
        return bytes;
    }

    private static bool TrySend(SocketClient peer, byte[] bytes)
    {
        try
        {
            peer.Stream.Write(bytes);
            return true;
        }
        catch (IOException)
        {
            return false;
        }
    }

    private static bool TryWrite(SocketClient peer, byte one) => TrySend(peer, [one]);
}
