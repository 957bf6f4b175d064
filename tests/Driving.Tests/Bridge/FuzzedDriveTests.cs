using System.Buffers.Binary;
using System.Text;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>A complete drive over a real socket, with malicious or broken clients.</summary>
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
    public void Mutated_messages_never_end_the_drive_or_oversteer(Type controller)
    {
        var game = new FakeGame();
        var car = new FakeCar();
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, new DrivingOptions().Picture);
        using var session = new DrivingSession(
            new DrivingOptions { SettleTicks = 0 },
            game.Ports with
            {
                Car = car,
            },
            bridge,
            () => controller == typeof(StanleyController) ? new StanleyController(new StanleyOptions()) : new DeepDrivingController()
        );
        var random = new Random(13);
        int refused = 0;
        for (int i = 0; i < 10_000; i++)
        {
            // Each uses a connection of its own, since the first bad message of a connection is the last that is read.
            using (var client = new SocketClient(bridge.EndPoint))
            {
                (byte[] bytes, bool drives) = Mutated(random);
                client.Stream.Write(bytes);
                if (drives)
                {
                    AwaitControls(session, game);
                }

                refused += client.SayNoMore().Contains("\"type\":\"error\"", StringComparison.Ordinal) ? 1 : 0;
            }

            session.Tick();
            game.Tick();
        }

        Assert.False(session.Status.IsOver, session.Status.Ending);
        Assert.InRange(refused, 1_000, 9_000);
        Assert.Contains(car.Driven, controls => controls != DrivingControls.Stop);
        Assert.All(
            car.Driven,
            controls =>
                Assert.True(Math.Abs(controls.Steering) <= 1 && controls.Throttle is >= 0 and <= 1 && controls.Brake is >= 0 and <= 1)
        );

        using var good = new SocketClient(bridge.EndPoint);
        good.Send("""{"type":"controls","steering":0.625,"throttle":0,"brake":0}""");
        Frames.Await(
            () =>
            {
                game.Tick();
                return session.Tick().Controls.Steering == 0.625;
            },
            "the good client to drive"
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Clients_that_trickle_bytes_are_cut_off_and_delay_nobody()
    {
        const string token = "open sesame";
        SocketBridgeOptions options = SocketBridgeOptions.Loopback with
        {
            Port = 0,
            Token = token,
            HelloPatience = TimeSpan.FromSeconds(10),
        };
        using var bridge = new SocketBridge(options, Frames.Size);
        SocketClient[] slow = [.. Enumerable.Range(0, 10).Select(_ => new SocketClient(bridge.EndPoint, hello: null))];
        using SocketClient good = Welcomed(bridge);

        // None of the reads waits for long, and at this pace the whole of this hello would take more than an hour.
        byte[] hello = Framed(
            Encoding.UTF8.GetBytes(
                string.Concat("{\"type\":\"hello\",\"version\":1,", new string(' ', 60_000), "\"token\":\"open sesame\"}")
            )
        );
        int sent = 0;
        Frames.Await(
            () =>
            {
                Thread.Sleep(100);
                sent++;
                return !slow.Any(client => client.TryWrite([hello[sent - 1]]));
            },
            "the slow ones to be cut off"
        );

        Assert.All(slow, client => Assert.True(client.IsCutOff()));
        bridge.Publish(Frames.State(5), Frames.Picture(5));
        Assert.Equal(5, good.Receive().Header.GetProperty("frame").GetInt64());
        Assert.All(slow, client => client.Dispose());
    }

    [Theory]
    [InlineData(new byte[] { 0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0x80, 0, 0, 0, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0, 1, 0, 1, 0, 0, 0, 0 })]
    [InlineData(new byte[] { 0, 0, 0, 10, 0x7F, 0xFF, 0xFF, 0xFF })]
    [InlineData(new byte[] { 0, 0, 0, 10, 0xFF, 0xFF, 0xFF, 0xFF })]
    [InlineData(new byte[] { 0, 0, 0, 0, 0, 0, 0, 0 })]
    public void Excessive_message_lengths_are_refused_before_reading(byte[] lengths)
    {
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);
        client.Stream.Write(lengths);

        Assert.Equal("error", client.Receive().Header.GetProperty("type").GetString());
        Assert.True(client.IsCutOff());
    }

    /// <summary>A client that has shown the token: on a busy machine it may be too late for that at first, and tries again.</summary>
    private static SocketClient Welcomed(SocketBridge bridge)
    {
        SocketClient client = Asking(bridge);
        Frames.Await(
            () =>
            {
                if (client.Stream.DataAvailable && client.ReceiveAny().Header.GetProperty("type").GetString() == "error")
                {
                    // The bridge reports that it was too late.
                    client.Dispose();
                    client = Asking(bridge);
                }

                return bridge.TryReceive(out ClientMessage? message) && message is RequestFrameMessage;
            },
            "the good client to be welcome"
        );
        return client;
    }

    private static SocketClient Asking(SocketBridge bridge)
    {
        var client = new SocketClient(bridge.EndPoint, hello: null);
        client.TryWrite(Framed("{\"type\":\"hello\",\"version\":1,\"token\":\"open sesame\"}"u8.ToArray()));
        client.TryWrite(Framed("{\"type\":\"requestFrame\"}"u8.ToArray()));
        return client;
    }

    private static void AwaitControls(DrivingSession session, FakeGame game) =>
        Frames.Await(
            () =>
            {
                game.Tick();
                return session.Tick().IsClientAlive;
            },
            "the controls of a client"
        );

    /// <summary>A valid message with bytes changed, removed or repeated, truncated, with other lengths, or unchanged.</summary>
    /// <returns>The bytes, and whether the car is driven by them for sure.</returns>
    private static (byte[] Bytes, bool Drives) Mutated(Random random)
    {
        string good = Good[random.Next(Good.Length)];
        List<byte> bytes = [.. Framed(Encoding.UTF8.GetBytes(good))];
        bool drives = false;
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
                drives = good.Contains("controls", StringComparison.Ordinal) || good.Contains("indicators", StringComparison.Ordinal);
                break;
        }

        return ([.. bytes], drives);
    }

    private static byte[] Framed(byte[] header)
    {
        byte[] bytes = new byte[8 + header.Length];
        BinaryPrimitives.WriteInt32BigEndian(bytes, header.Length);
        header.CopyTo(bytes, 8);
        return bytes;
    }
}
