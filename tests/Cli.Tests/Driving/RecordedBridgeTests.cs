using System.Runtime.CompilerServices;
using System.Text.Json;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Tests.Driving;

/// <summary>What is recorded of a client that drives, read as JSON.</summary>
public sealed class RecordedBridgeTests : IDisposable
{
    private const double TickSeconds = 0.05;
    private static readonly DrivingControls FullThrottle = new(0, 1, 0);
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public void Slow_client_has_answered_every_recorded_frame()
    {
        using var bridge = new SlowBridge(ticks: 17);
        Record(bridge, new DrivingOptions { Picture = new ImageSize(32, 24), WaitsForAnswers = true }, ticks: 300);

        JsonElement[] drives = Drives();
        Assert.InRange(drives.Length, 15, 18);
        Assert.All(
            drives[..^1],
            drive =>
            {
                Assert.Equal(1, drive.GetProperty("controls").GetProperty("throttle").GetDouble());
                Assert.InRange(drive.GetProperty("answerSeconds").GetDouble(), 16 * TickSeconds, 19 * TickSeconds);
            }
        );
        Assert.Equal(bridge.Sent, drives.Select(drive => drive.GetProperty("bridgeFrame").GetInt64()));
    }

    [Fact]
    public void Nothing_is_recorded_without_a_client()
    {
        using var bridge = new SlowBridge(ticks: 1) { Client = null };
        Record(bridge, new DrivingOptions { Picture = new ImageSize(32, 24) }, ticks: 40);

        Assert.False(File.Exists(_folder.PathOf("session/labels.jsonl")));
    }

    [Fact]
    public void Tick_that_brakes_for_a_silent_client_has_no_driver()
    {
        using var bridge = new AnsweringBridge(
            static state => state.Frame == 0 ? [new ControlsMessage(FullThrottle, 0), new StepMessage(1)] : [],
            new RequestFrameMessage()
        );
        Record(bridge, new DrivingOptions { Picture = new ImageSize(32, 24), IsLockStep = true }, ticks: 25);

        JsonElement[] ticks = [.. Drives()[0].GetProperty("ticks").EnumerateArray()];
        Assert.Equal(["client", "none"], ticks.Select(tick => tick.GetProperty("driver").GetString()).Distinct());
        Assert.All(
            ticks,
            tick =>
                Assert.Equal(
                    tick.GetProperty("driver").GetString() == "client" ? 1 : 0,
                    tick.GetProperty("applied").GetProperty("throttle").GetDouble()
                )
        );
    }

    [Fact]
    public void Answer_to_a_repeated_frame_is_that_of_the_recorded_one()
    {
        using var bridge = new AnsweringBridge(
            static state =>
                state.Frame switch
                {
                    0 => [new RequestFrameMessage()],
                    1 => [new ControlsMessage(FullThrottle, 1), new StepMessage(0.2)],
                    _ => [],
                },
            new RequestFrameMessage()
        );
        Record(bridge, new DrivingOptions { Picture = new ImageSize(32, 24), IsLockStep = true }, ticks: 10);

        JsonElement first = Drives()[0];
        Assert.Equal(0, first.GetProperty("bridgeFrame").GetInt64());
        Assert.Equal(1, first.GetProperty("controls").GetProperty("throttle").GetDouble());
    }

    [Fact]
    public void Inertial_sensor_does_not_measure_a_short_reset()
    {
        SimulatedGame game = Game();
        Pose at = game.Ports.World.ReadEgo().Pose;
        double heading = Angles.HeadingDegrees(at.Axes.Forward);
        using var bridge = new AnsweringBridge(
            state =>
                state.Frame switch
                {
                    0 => [new ControlsMessage(FullThrottle, 0), new StepMessage(0.4)],
                    1 => [new ResetMessage(at.Position, heading), new StepMessage(0.2)],
                    _ => [],
                },
            new RequestFrameMessage()
        );
        Record(bridge, new DrivingOptions { Picture = new ImageSize(32, 24), IsLockStep = true }, ticks: 25, game);

        JsonElement[] measured =
        [
            .. Drives().SelectMany(drive => drive.GetProperty("ticks").EnumerateArray()).Select(tick => tick.GetProperty("acceleration")),
        ];
        Assert.Single(measured, each => each.ValueKind == JsonValueKind.Null);
        Assert.All(measured.Where(each => each.ValueKind != JsonValueKind.Null), each => Assert.InRange(each[1].GetDouble(), -9, 5));
    }

    [Fact]
    public void Recording_that_has_ended_keeps_no_game()
    {
        using DriveRecording recording = NewRecording(isNumbered: true);
        WeakReference game = EndedGame(recording);

        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();

        Assert.False(game.IsAlive);
        recording.Finish();
        Assert.True(File.Exists(_folder.PathOf("session/0001/labels.jsonl")));
    }

    public void Dispose() => _folder.Dispose();

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference EndedGame(DriveRecording recording)
    {
        SimulatedGame game = Game();
        using GameRecording recorded = recording.Of(game, new FixedRoads(game.Roads, "simulation"), 1);
        recorded.Look();
        return new WeakReference(game);
    }

    private static SimulatedGame Game() =>
        new(
            new SimulationOptions
            {
                Seed = 1,
                TrafficDensity = 0,
                PedestrianDensity = 0,
            }
        );

    private DriveRecording NewRecording(bool isNumbered = false) =>
        new(
            static _ => { },
            new RecordPlan(_folder.PathOf("session"), 0.2, new ImageSize(32, 24)) { IsNumbered = isNumbered },
            "drive",
            overwrite: false
        );

    private void Record(IDrivingBridge bridge, DrivingOptions options, int ticks, SimulatedGame? driven = null)
    {
        SimulatedGame game = driven ?? Game();
        FixedRoads roads = new(game.Roads, "simulation");
        using DriveRecording recording = NewRecording();
        using (
            var endpoint = new GameEndpoint(game, roads, options, bridge, static () => new DeepDrivingController(), isAssisted: false)
            {
                Recording = recording.Of(game, roads, 1),
            }
        )
        {
            endpoint.Tick(0);
            for (int tick = 0; tick < ticks; tick++)
            {
                endpoint.Tick(TickSeconds);
            }
        }

        recording.Finish();
    }

    private JsonElement[] Drives() =>
        [
            .. File.ReadLines(_folder.PathOf("session/labels.jsonl"))
                .Select(line => JsonDocument.Parse(line).RootElement.GetProperty("drive")),
        ];

    /// <summary>A bridge to a client that answers each frame after some ticks. It is sent a frame when it has answered the last.</summary>
    private sealed class SlowBridge(int ticks) : IDrivingBridge, IClientInbox, IFrameOutbox
    {
        private long? _unanswered;
        private int _waited;

        /// <summary>Numbers of the frames that were sent.</summary>
        public List<long> Sent { get; } = [];

        public string? Problem => null;

        public string? Client { get; init; } = "the test";

        public IClientInbox Inbox => this;

        public IFrameOutbox Outbox => this;

        public bool HasClientGone => false;

        public bool IsFrameAwaited => _unanswered is null;

        public bool Publish(BridgeState state, Sessions.Imaging.PixelBuffer picture)
        {
            if (_unanswered is null)
            {
                (_unanswered, _waited) = (state.Frame, 0);
                Sent.Add(state.Frame);
            }

            return true;
        }

        public bool TryReceive([System.Diagnostics.CodeAnalysis.NotNullWhen(true)] out ClientMessage? message)
        {
            bool isAnswer = _unanswered is not null && ++_waited > ticks;
            message = isAnswer ? new ControlsMessage(FullThrottle, _unanswered) : null;
            _unanswered = isAnswer ? null : _unanswered;
            return isAnswer;
        }

        public void Dispose() { }
    }
}
