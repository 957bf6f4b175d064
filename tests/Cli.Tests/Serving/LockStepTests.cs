using System.Globalization;
using System.Net;
using System.Text;
using System.Text.Json;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Runs.Serving;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Serving;

/// <summary>A served game in lock-step, over the socket.</summary>
public sealed class LockStepTests
{
    private static readonly SimulationOptions World = new()
    {
        Seed = 1,
        TrafficDensity = 0.3,
        PedestrianDensity = 0.3,
    };

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    [Trait("Category", "Heavy")]
    public async Task Same_seed_and_actions_give_the_same_bytes(bool isAssisted)
    {
        using Served first = new(isAssisted);
        byte[] of = Drive(first, seed: 5, hesitates: false);

        // What happened before a restart leaves nothing, nor does the time at which the client asks.
        byte[] other = Drive(first, seed: 6, hesitates: false);
        byte[] again = Drive(first, seed: 5, hesitates: true);
        using Served second = new(isAssisted);
        byte[] elsewhere = Drive(second, seed: 5, hesitates: true);

        Assert.NotEqual(of, other);
        Assert.Equal(of, again);
        Assert.Equal(of, elsewhere);
        await first.StopAsync();
        await second.StopAsync();
    }

    [Fact]
    public async Task World_stands_still_but_for_steps()
    {
        using Served served = new();
        using SocketClient client = new(served.EndPoint);
        client.Send("""{"type":"requestFrame","image":false}""");
        double before = client.Receive().Header.GetProperty("timeSeconds").GetDouble();
        await Task.Delay(200);
        client.Send("""{"type":"pause","paused":false}""");
        client.Send("""{"type":"requestFrame","image":false}""");
        double after = client.Receive().Header.GetProperty("timeSeconds").GetDouble();
        client.Send("""{"type":"step","seconds":0.2,"image":false}""");
        double stepped = client.Receive().Header.GetProperty("timeSeconds").GetDouble();

        Assert.Equal([0, 0, 0.2], [before, after, stepped]);
        await served.StopAsync();
    }

    [Fact]
    public async Task Steps_sent_after_a_restart_are_for_the_new_game()
    {
        using Served served = new();
        using SocketClient client = new(served.EndPoint);
        client.Send("""{"type":"step","seconds":0.1,"image":false}""");
        client.Send("""{"type":"restart","seed":3,"image":false}""");
        client.Send("""{"type":"step","seconds":0.1,"image":false}""");
        client.Send("""{"type":"step","seconds":0.3,"image":false}""");

        // A frame that was not sent yet gives way to a newer one, but the last comes.
        double time;
        do
        {
            time = TimeOf(client);
            Assert.InRange(time, 0, 0.4);
        } while (time < 0.4);
        await served.StopAsync();
    }

    [Fact]
    public async Task Frame_has_an_image_unless_none_is_wanted()
    {
        using Served served = new();
        using SocketClient client = new(served.EndPoint);
        client.Send("""{"type":"restart","seed":3,"image":false}""");
        Assert.Empty(client.Receive().Payload);
        client.Send("""{"type":"step","seconds":0.1}""");
        Assert.Equal("PNG"u8.ToArray(), client.Receive().Payload[1..4]);
        client.Send("""{"type":"step","seconds":0.1,"image":false}""");
        Assert.Empty(client.Receive().Payload);
        await served.StopAsync();
    }

    [Fact]
    public async Task Frame_tells_the_true_drive()
    {
        using Served served = new();
        using SocketClient client = new(served.EndPoint);
        JsonElement frame = default;
        double metres = 0;
        client.Send("""{"type":"restart","seed":3,"image":false}""");
        client.Receive();
        for (int step = 0; step < 20; step++)
        {
            client.Send("""{"type":"controls","steering":0,"throttle":0.5,"brake":0}""");
            client.Send("""{"type":"step","seconds":0.1,"image":false}""");
            frame = client.Receive().Header;
            metres += 0.1 * frame.GetProperty("speedMetresPerSecond").GetDouble();
        }

        // The speed at the end of each step overestimates an accelerating car by half of its gain: 0.5 x 4 m/s² x 2 s x 0.1 s / 2.
        const double late = 0.25;
        Assert.InRange(metres - frame.GetProperty("drivenMetres").GetDouble(), 0, late);
        Assert.True(metres > 2, $"{metres} m");
        Assert.Equal([0, 0.5, 0], frame.GetProperty("appliedControls").EnumerateArray().Select(number => number.GetDouble()));
        Assert.False(frame.GetProperty("builtInDriver").GetBoolean());
        await served.StopAsync();
    }

    [Fact]
    public async Task Client_that_goes_leaves_the_world_standing()
    {
        using Served served = new();
        using (SocketClient first = new(served.EndPoint))
        {
            first.Send("""{"type":"step","seconds":0.1,"image":false}""");
            first.Receive();
        }

        await Task.Delay(200);
        using SocketClient second = new(served.EndPoint);
        second.Send("""{"type":"requestFrame","image":false}""");

        Assert.Equal(0.1, TimeOf(second));
        await served.StopAsync();
    }

    [Fact]
    public void Game_in_real_time_refuses_a_restart()
    {
        using SocketBridge bridge = new(new SocketBridgeOptions(IPAddress.Loopback, 0, null), new ImageSize(32, 24));
        using SocketClient client = new(bridge.EndPoint);
        client.Send("""{"type":"restart","seed":1}""");

        Assert.Contains("--lockstep", client.Receive().Header.GetProperty("reason").GetString(), StringComparison.Ordinal);
        Assert.True(client.IsCutOff());
    }

    [Fact]
    public async Task Game_for_one_client_ends_with_it()
    {
        IPEndPoint at = new(IPAddress.Loopback, FreePort.Find());
        Task<CliRun> serve = CliRun.BesideAsync(
            CancellationToken.None,
            "serve",
            "--lockstep",
            "--once",
            "--port",
            at.Port.ToString(CultureInfo.InvariantCulture),
            "--traffic",
            "0",
            "--size",
            "80x60"
        );
        using (SocketClient client = Connect(at, serve))
        {
            client.Send("""{"type":"restart","seed":2}""");
            client.Receive();
            client.Send("""{"type":"step","seconds":0.1}""");
            client.Receive();
        }

        CliRun run = await serve.WaitAsync(TimeSpan.FromSeconds(60));
        Assert.EndsWith("2 frames, 0 m driven in 0.1 s\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Restart_takes_its_start_from_the_seed_not_from_near()
    {
        (JsonElement First, JsonElement Restarted) here = await StartsAsync("0,0");
        (JsonElement First, JsonElement Restarted) there = await StartsAsync("50,50");

        Assert.NotEqual(here.First.GetRawText(), there.First.GetRawText());
        Assert.Equal(here.Restarted.GetRawText(), there.Restarted.GetRawText());
        Assert.Contains("a restart takes its start from its seed", OnOneLine(CliRun.Of("serve", "--help").Out), StringComparison.Ordinal);
    }

    private static string OnOneLine(string text) => string.Join(' ', text.Split([' ', '\n'], StringSplitOptions.RemoveEmptyEntries));

    /// <summary>Where the car of a game stands first, and where after a restart.</summary>
    private static async Task<(JsonElement First, JsonElement Restarted)> StartsAsync(string near)
    {
        IPEndPoint at = new(IPAddress.Loopback, FreePort.Find());
        Task<CliRun> serve = CliRun.BesideAsync(
            CancellationToken.None,
            "serve",
            "--lockstep",
            "--once",
            "--port",
            at.Port.ToString(CultureInfo.InvariantCulture),
            "--traffic",
            "0",
            "--size",
            "80x60",
            "--near",
            near
        );
        (JsonElement First, JsonElement Restarted) starts;
        using (SocketClient client = Connect(at, serve))
        {
            client.Send("""{"type":"requestFrame","image":false}""");
            JsonElement first = client.Receive().Header.GetProperty("position");
            client.Send("""{"type":"restart","seed":2,"image":false}""");
            starts = (first, client.Receive().Header.GetProperty("position"));
        }

        await serve.WaitAsync(TimeSpan.FromSeconds(60));
        return starts;
    }

    private static double TimeOf(SocketClient client) => client.Receive().Header.GetProperty("timeSeconds").GetDouble();

    private static SocketClient Connect(IPEndPoint at, Task<CliRun> serve)
    {
        DateTime deadline = DateTime.UtcNow.AddSeconds(60);
        while (true)
        {
            try
            {
                return new SocketClient(at);
            }
            catch (System.Net.Sockets.SocketException) when (DateTime.UtcNow < deadline && !serve.IsCompleted)
            {
                Thread.Sleep(50);
            }
        }
    }

    /// <summary>Restarts and drives: all bytes that the game sends but its hello. Every fifth frame has an image.</summary>
    private static byte[] Drive(Served served, int seed, bool hesitates)
    {
        using SocketClient client = new(served.EndPoint);
        using MemoryStream all = new();
        client.Send($$"""{"type":"restart","seed":{{seed}}}""");
        Take();
        for (int step = 0; step < 40; step++)
        {
            string steering = step % 20 < 10 ? "0.05" : "-0.05";
            client.Send($$"""{"type":"controls","steering":{{steering}},"throttle":0.4,"brake":0}""");
            if (hesitates && step % 7 == 0)
            {
                // The controls arrive by themselves.
                Thread.Sleep(5);
            }

            client.Send($$"""{"type":"step","seconds":0.1,"image":{{(step % 5 == 0 ? "true" : "false")}}}""");
            Take();
        }

        return all.ToArray();

        void Take()
        {
            (JsonElement header, byte[] payload) = client.Receive();
            all.Write(Encoding.UTF8.GetBytes(header.GetRawText()));
            all.Write(payload);
        }
    }

    /// <summary>A game that is served on a thread of its own.</summary>
    private sealed class Served : IDisposable
    {
        private readonly SocketBridge _bridge;
        private readonly CancellationTokenSource _stopping = new();
        private readonly Task<string?> _serving;

        public Served(bool isAssisted = false)
        {
            ImageSize size = new(64, 48);
            _bridge = new SocketBridge(new SocketBridgeOptions(IPAddress.Loopback, 0, null) { CanRestart = true }, size);
            DrivingOptions options = new() { Picture = size, IsLockStep = true };
            LockStepGame game = new(
                _bridge,
                restart => new SimulatedGame(World with { TrafficSeed = restart?.Seed, StartSeed = restart?.Seed }),
                game => new GameEndpoint(
                    game,
                    new FixedRoads(game.Roads, "simulation"),
                    options,
                    _bridge,
                    static () => new DeepDrivingController(),
                    isAssisted
                )
            );
            _serving = Task.Factory.StartNew(
                () => game.Run(double.PositiveInfinity, _stopping.Token),
                CancellationToken.None,
                TaskCreationOptions.LongRunning,
                TaskScheduler.Default
            );
        }

        public IPEndPoint EndPoint => _bridge.EndPoint;

        public async Task StopAsync()
        {
            await _stopping.CancelAsync();
            Assert.Null(await _serving);
        }

        public void Dispose()
        {
            _stopping.Cancel();
            _bridge.Dispose();
            _stopping.Dispose();
        }
    }
}
