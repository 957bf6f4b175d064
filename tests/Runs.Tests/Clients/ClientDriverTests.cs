using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Runs.Clients;

namespace Harvester.Runs.Tests.Clients;

public sealed class ClientDriverTests
{
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);

    [Fact]
    public void Run_answers_frames_until_the_time_is_over()
    {
        using FakeLink link = new(Enumerable.Range(0, 100).Select(i => FrameAt(i, 10 * 0.1 * i)));
        ClientDriver driver = new(link, static () => new StandingController(), Ample, TimeProvider.System);
        driver.Run(null, 2, default);

        // Frames at 0.0 to 2.0 s, ten metres a second.
        Assert.Equal(21, driver.Frames);
        Assert.Equal(2, driver.Seconds, 9);
        Assert.Equal(20, driver.Metres, 9);
        Assert.Equal((21, 0), (link.Answers, link.Steps));
    }

    [Fact]
    public void Run_without_frames_gives_up()
    {
        using FakeLink link = new([]);
        ClientDriver driver = new(link, static () => new StandingController(), TimeSpan.FromSeconds(0.05), TimeProvider.System);

        Assert.Equal(
            "No frame has arrived from the game for 0.05 s.",
            Assert.Throws<IOException>(() => driver.Run(null, 2, default)).Message
        );
    }

    [Fact]
    public void Run_in_lock_step_repeats_a_lost_answer()
    {
        using LockStepGame game = new() { LostSteps = 1 };
        ClientDriver driver = new(game, static () => new StandingController(), Ample, game);
        driver.Run(0.1, 5, default);

        // Frames at 0.0 to 5.0 s; the first is answered twice.
        Assert.Equal((51, 52, 1), (driver.Frames, game.Steps, game.Asked));
    }

    [Fact]
    public void Run_in_lock_step_answers_each_frame_once_in_a_long_step()
    {
        using LockStepGame game = new() { LooksOfFirstStep = 70 };
        ClientDriver driver = new(game, static () => new StandingController(), Ample, game);
        driver.Run(0.1, 5, default);

        // It requests a frame after 2, 4 and 6 of the 7 seconds.
        Assert.Equal((51, 51, 3), (driver.Frames, game.Steps, game.Asked));
    }

    [Fact]
    public void Run_repeats_nothing_over_a_reliable_link()
    {
        using LockStepGame game = new() { LooksOfFirstStep = 70, MayLose = false };
        ClientDriver driver = new(game, static () => new StandingController(), Ample, game);
        driver.Run(0.1, 5, default);

        Assert.Equal((51, 51, 0), (driver.Frames, game.Steps, game.Asked));
    }

    [Theory]
    [InlineData(null)]
    [InlineData(0.1)]
    public void Run_requests_the_first_frame_until_it_arrives(double? stepSeconds)
    {
        using LockStepGame game = new() { AskingsUntilItShows = 3 };
        ClientDriver driver = new(game, static () => new StandingController(), Ample, game);
        driver.Run(stepSeconds, 0, default);
        Assert.Equal((0, 0), (driver.Frames, game.Asked));

        using CancellationTokenSource heard = new();
        game.Answered = heard.Cancel;
        driver.Run(stepSeconds, 1, heard.Token);

        Assert.Equal((1, 3), (driver.Frames, game.Asked));
    }

    [Fact]
    public void Run_starts_a_new_controller_when_the_car_was_teleported()
    {
        int made = 0;
        using FakeLink link = new([FrameAt(0, 0), FrameAt(1, 1), FrameAt(2, 200), FrameAt(3, 201)]);
        ClientDriver driver = new(
            link,
            () =>
            {
                made++;
                return new StandingController();
            },
            Ample,
            TimeProvider.System
        );
        driver.Run(null, 0.3, default);

        Assert.Equal(2, made);
    }

    [Fact]
    public async Task Run_ends_when_the_game_closes_the_bridge()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        ClientDriver driver = new(link, static () => new StandingController(), Ample, TimeProvider.System);
        game.Say(FakeGame.Frame(1));
        Task driving = Task.Factory.StartNew(
            () => driver.Run(null, 60, default),
            CancellationToken.None,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default
        );
        game.Receive();
        game.Receive();
        Assert.Contains("\"controls\"", game.Receive(), StringComparison.Ordinal);
        game.Close();
        await driving.WaitAsync(Ample);

        Assert.True(driver.IsEndedByGame);
        Assert.Equal(1, driver.Frames);
    }

    [Fact]
    public void Run_that_is_refused_fails()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Receive();
        game.Close();

        Assert.ThrowsAny<IOException>(() =>
            new ClientDriver(link, static () => new StandingController(), Ample, TimeProvider.System).Run(null, 60, default)
        );
    }

    private static ClientFrame FrameAt(int number, double x) =>
        new(
            number,
            number * 0.1,
            new DrivingState(LaneIndicators.Unknown, LaneIndicators.Unknown, IsFast: false, 10),
            new Vector3D(x, 0, 0)
        );

    private sealed class StandingController : IController
    {
        public DrivingControls Drive(DrivingState state) => DrivingControls.Stop;
    }

    private sealed class FakeLink(IEnumerable<ClientFrame?> frames) : IBridgeLink
    {
        private readonly Queue<ClientFrame?> _frames = new(frames);

        public int Answers { get; private set; }

        public int Steps { get; private set; }

        public bool MayLose => true;

        public ClientFrame? Receive(TimeSpan patience)
        {
            Thread.Sleep(1);
            return _frames.Count > 0 ? _frames.Dequeue() : null;
        }

        public void Send(DrivingControls controls, long frame) => Answers++;

        public void AskForFrame() { }

        public void Step(double seconds) => Steps++;

        public void Dispose() { }
    }

    /// <summary>
    /// A game that goes on by a tenth of a second with each step and shows the world then. While a step goes on it obeys nothing else. A
    /// look at it takes as long as the client is patient, on a clock of its own.
    /// </summary>
    private sealed class LockStepGame : TimeProvider, IBridgeLink
    {
        private readonly Queue<ClientFrame> _frames = [];
        private readonly Queue<bool> _steps = [];
        private TimeSpan _now;
        private int _world;
        private int _looksLeft;
        private bool _isAskedFor = true;

        public bool MayLose { get; init; } = true;

        /// <summary>So many of the first steps are not heard.</summary>
        public int LostSteps { get; init; }

        public int LooksOfFirstStep { get; init; } = 1;

        /// <summary>Number of requests before it shows a frame.</summary>
        public int AskingsUntilItShows { get; init; }

        public Action Answered { get; set; } = static () => { };

        public int Steps { get; private set; }

        public int Asked { get; private set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => _now.Ticks;

        public ClientFrame? Receive(TimeSpan patience)
        {
            _now += patience;
            if (_looksLeft > 0 && --_looksLeft == 0)
            {
                _frames.Enqueue(FrameAt(++_world, _world));
            }

            if (_looksLeft == 0)
            {
                if (_isAskedFor && Asked >= AskingsUntilItShows)
                {
                    _frames.Enqueue(FrameAt(_world, _world));
                    _isAskedFor = false;
                }

                _looksLeft =
                    !_steps.TryDequeue(out bool isFirst) ? 0
                    : isFirst ? LooksOfFirstStep
                    : 1;
            }

            return _frames.TryDequeue(out ClientFrame? frame) ? frame : null;
        }

        public void Send(DrivingControls controls, long frame) => Answered();

        public void AskForFrame()
        {
            Asked++;
            _isAskedFor = true;
        }

        public void Step(double seconds)
        {
            if (++Steps > LostSteps)
            {
                _steps.Enqueue(Steps == 1);
            }
        }

        public void Dispose() { }
    }
}
