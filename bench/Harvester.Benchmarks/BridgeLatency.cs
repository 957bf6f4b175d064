using System.Buffers.Binary;
using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Benchmarks;

/// <summary>
/// Time from the tick that takes a frame to the tick that drives the car by the answer to it, over the socket, with a simulated game of
/// 60 ticks and 10 frames a second and a client that answers at once. The steering of an answer tells which frame it is for. The picture
/// is rendered once: how long the simulated game draws is no matter of the bridge. The exit code is 1 where one of a hundred takes as
/// long as the time from frame to frame.
/// </summary>
internal sealed class BridgeLatency : IDrivenCar, IScreen
{
    private const double TicksPerSecond = 60;
    private const int Frames = 1000;
    private const double MillisecondsPerFrame = 100;
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly Dictionary<int, double> _taken = [];
    private readonly List<double> _latencies = [];

    private byte[] _picture = [];

    public bool IsTakenByPlayer => false;

    public static void Run(int frames)
    {
        var measured = new BridgeLatency();
        measured.Drive(frames);
        double[] sorted = [.. measured._latencies.Order()];
        Console.WriteLine(
            string.Create(
                CultureInfo.InvariantCulture,
                $"{sorted.Length} of {frames} frames answered; ms from frame to applied control: median {At(0.5):0.0}, 99th hundredth "
                    + $"{At(0.99):0.0}, most {sorted[^1]:0.0}"
            )
        );
        Environment.ExitCode = sorted.Length == 0 || At(0.99) >= MillisecondsPerFrame ? 1 : 0;

        double At(double share) => sorted[(int)Math.Ceiling(share * sorted.Length) - 1];
    }

    public void Drive(DrivingControls controls)
    {
        int frame = (int)Math.Round(controls.Steering * Frames);
        if (controls.Brake == 0 && _taken.Remove(frame, out double taken))
        {
            _latencies.Add(_clock.Elapsed.TotalMilliseconds - taken);
        }
    }

    public GrabResult Grab(PixelBuffer target)
    {
        _picture.CopyTo(target.Bytes, 0);
        return GrabResult.Good;
    }

    public void Reset(Vector3D position, double headingDegrees) { }

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) { }

    private static void Answer(IPEndPoint place)
    {
        using var connection = new TcpClient { NoDelay = true };
        connection.Connect(place);
        NetworkStream stream = connection.GetStream();
        byte[] lengths = new byte[8];
        Send("{\"type\":\"hello\",\"version\":1}");
        while (stream.ReadAtLeast(lengths, lengths.Length, throwOnEndOfStream: false) == lengths.Length)
        {
            byte[] header = new byte[BinaryPrimitives.ReadInt32BigEndian(lengths)];
            byte[] picture = new byte[BinaryPrimitives.ReadInt32BigEndian(lengths.AsSpan(4))];
            stream.ReadExactly(header);
            stream.ReadExactly(picture);
            using JsonDocument state = JsonDocument.Parse(header);
            if (!state.RootElement.TryGetProperty("frame", out JsonElement frame))
            {
                // The game's hello.
                continue;
            }

            double steering = frame.GetInt64() % Frames / (double)Frames;
            Send(
                string.Create(CultureInfo.InvariantCulture, $"{{\"type\":\"controls\",\"steering\":{steering},\"throttle\":0,\"brake\":0}}")
            );
        }

        void Send(string json)
        {
            byte[] message = Encoding.UTF8.GetBytes(json);
            BinaryPrimitives.WriteInt32BigEndian(lengths, message.Length);
            BinaryPrimitives.WriteInt32BigEndian(lengths.AsSpan(4), 0);
            stream.Write([.. lengths, .. message]);
        }
    }

    private void Drive(int frames)
    {
        var options = new DrivingOptions { SettleTicks = 0 };
        var game = new SimulatedGame(new SimulationOptions { Seed = 1 });
        var picture = new PixelBuffer(options.Picture);
        game.Ports.Screen.Grab(picture);
        _picture = picture.Bytes;
        using var bridge = new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, options.Picture);
        using var session = new DrivingSession(
            options,
            game.Ports with
            {
                Car = this,
                Screen = this,
                Roads = new FixedRoads(game.Roads, "simulation"),
            },
            bridge,
            static () => new DeepDrivingController()
        );
        var client = new Thread(() => Answer(bridge.EndPoint)) { IsBackground = true };
        client.Start();
        for (long tick = 0; session.Status.Frames < frames; tick++)
        {
            double start = _clock.Elapsed.TotalMilliseconds;
            long before = session.Status.Frames;
            if (session.Tick().Frames > before)
            {
                _taken[(int)(before % Frames)] = start;
            }

            game.Tick(1 / TicksPerSecond);
            double wait = start + (1000 / TicksPerSecond) - _clock.Elapsed.TotalMilliseconds;
            Thread.Sleep((int)Math.Max(0, wait));
        }
    }
}
