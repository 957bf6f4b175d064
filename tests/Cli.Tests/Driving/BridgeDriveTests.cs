using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Runs.Driving;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Faults;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Tests.Driving;

public sealed class BridgedDriveTests
{
    private static readonly TimeSpan Little = TimeSpan.FromSeconds(0.2);
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);
    private static readonly DrivingControls Gentle = new(0, 0.2, 0);

    [Fact]
    public void Run_after_a_fault_of_the_game_fails_and_does_not_wait()
    {
        using AnsweringBridge bridge = new(_ => throw new InvalidOperationException("the screen is gone"), new RequestFrameMessage());

        GameFaultException fault = Assert.Throws<GameFaultException>(() => Drive(bridge, TimeSpan.FromHours(1)));
        Assert.Contains("the screen is gone", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_with_a_fault_in_the_middle_of_the_drive_fails()
    {
        using AnsweringBridge bridge = new(
            state =>
                state.Frame < 5
                    ? [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)]
                    : throw new InvalidOperationException("the screen is gone"),
            new RequestFrameMessage()
        );

        Assert.Throws<GameFaultException>(() => Drive(bridge, TimeSpan.FromHours(1)));
    }

    [Fact]
    public void Run_without_a_client_gives_up()
    {
        using AnsweringBridge bridge = new(_ => []);

        IOException fault = Assert.Throws<IOException>(() => Drive(bridge, Little));
        Assert.Equal("No client has driven for 0.2 s.", fault.Message);
    }

    [Fact]
    public void Run_gives_up_on_a_client_that_pauses_and_falls_silent()
    {
        using AnsweringBridge bridge = new(
            state => state.Frame < 5 ? [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)] : [],
            new RequestFrameMessage()
        );

        Assert.Throws<IOException>(() => Drive(bridge, Little));
    }

    [Fact]
    public void Run_waits_for_a_client_that_joins_after_the_first_frame()
    {
        // Nobody was there for frame 0.
        using AnsweringBridge bridge = new(state =>
            state.Frame == 0 ? [] : [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)]
        );

        Assert.NotEmpty(Drive(bridge, Ample, metres: 1));
    }

    [Fact]
    public void Run_continues_with_a_client_that_starts_with_a_step()
    {
        using AnsweringBridge bridge = new(state =>
            [new StepMessage(0.1), .. state.TimeSeconds > 0 ? [new ControlsMessage(Gentle, null)] : Array.Empty<ClientMessage>()]
        );

        Assert.NotEmpty(Drive(bridge, Ample, metres: 1));
    }

    [Fact]
    public void Run_in_real_time_does_not_catch_up_after_a_pause()
    {
        var pause = TimeSpan.FromSeconds(0.5);
        using PausingBridge bridge = new(pause);
        using CancellationTokenSource stopping = new();
        bridge.AfterPause = frames =>
        {
            if (frames == 6)
            {
                stopping.Cancel();
            }
        };
        Drive(bridge, TimeSpan.FromHours(1), isRealTime: true, stopping: stopping.Token);

        // From the first frame after the pause to the sixth it is half a second; a timer may end a wait a little early, and there are ten
        // waits.
        Assert.InRange(bridge.SinceFirstAfterPause, TimeSpan.FromSeconds(0.4), TimeSpan.MaxValue);
    }

    [Fact]
    public void Run_that_is_stopped_gives_what_it_has()
    {
        using CancellationTokenSource stopping = new();
        using AnsweringBridge bridge = new(
            state =>
            {
                if (state.Frame == 10)
                {
                    stopping.Cancel();
                }

                return [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)];
            },
            new RequestFrameMessage()
        );

        // The tenth frame after the first is at 1.0 s: ten samples, or one more with the rest of its tick.
        Assert.InRange(Drive(bridge, TimeSpan.FromHours(1), stopping: stopping.Token).Count, 9, 11);
    }

    private static IReadOnlyList<DriveSample> Drive(
        IDrivingBridge bridge,
        TimeSpan patience,
        double metres = 100,
        bool isRealTime = false,
        CancellationToken stopping = default
    )
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 1,
                TrafficDensity = 0,
                PedestrianDensity = 0,
                WindowAspect = 4.0 / 3,
            }
        );
        BridgeDrive drive = new(
            game,
            new FixedRoads(game.Roads, "simulation"),
            bridge,
            static () => new StanleyController(new StanleyOptions()),
            patience
        );
        drive.Run(metres, 60, isRealTime, stopping);
        return drive.Samples;
    }

    /// <summary>To a client that answers each frame, and after the third one stops the world for a while.</summary>
    private sealed class PausingBridge(TimeSpan pause) : IDrivingBridge, IClientInbox, IFrameOutbox
    {
        private const int PauseAfter = 3;
        private readonly Queue<ClientMessage> _messages = new([new ControlsMessage(Gentle, null)]);
        private readonly Stopwatch _paused = new();
        private readonly Stopwatch _sinceFirst = new();
        private bool _isOver;
        private int _frames;

        public string? Problem => null;

        public string? Client => null;

        public Action<int> AfterPause { get; set; } = static _ => { };

        public TimeSpan SinceFirstAfterPause { get; private set; }

        public IClientInbox Inbox => this;

        public IFrameOutbox Outbox => this;

        public bool HasClientGone => false;

        public bool IsFrameAwaited => _messages.Count == 0;

        public bool Publish(BridgeState state, PixelBuffer picture)
        {
            _messages.Enqueue(new ControlsMessage(Gentle, state.Frame));
            if (_isOver)
            {
                _sinceFirst.Start();
                SinceFirstAfterPause = _sinceFirst.Elapsed;
                AfterPause(++_frames - PauseAfter);
            }
            else if (++_frames == PauseAfter)
            {
                _messages.Enqueue(new PauseMessage(true));
                _paused.Start();
            }

            return true;
        }

        public bool TryReceive([NotNullWhen(true)] out ClientMessage? message)
        {
            if (!_isOver && _paused.Elapsed > pause)
            {
                _isOver = true;
                _messages.Enqueue(new PauseMessage(false));
            }

            return _messages.TryDequeue(out message);
        }

        public void Dispose() { }
    }
}
