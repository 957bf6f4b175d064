using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Driving.Peers;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Tests.Peers;

public sealed class PeerDriverTests
{
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);

    [Fact]
    public void Run_answers_frames_until_the_time_is_over()
    {
        using FakeLink link = new(Enumerable.Range(0, 100).Select(i => FrameAt(i, 10 * 0.1 * i)));
        PeerDriver driver = new(link, static () => new StandingController(), Ample);
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
        PeerDriver driver = new(link, static () => new StandingController(), TimeSpan.FromSeconds(0.05));

        Assert.Equal("No frame of the game has come for 0.05 s.", Assert.Throws<IOException>(() => driver.Run(null, 2, default)).Message);
    }

    [Fact]
    public void Run_in_lock_step_answers_again_when_an_answer_is_lost()
    {
        // The game hears only the second answer to the first frame.
        using FakeLink link = new([FrameAt(0, 0), .. Enumerable.Repeat<PeerFrame?>(null, 10_000)]) { NextAfterAnswers = 2 };
        PeerDriver driver = new(link, static () => new StandingController(), Ample);
        driver.Run(0.1, 0.1, default);

        Assert.Equal(2, driver.Frames);
    }

    [Fact]
    public void Run_begins_with_a_new_controller_where_the_car_was_put_elsewhere()
    {
        int made = 0;
        using FakeLink link = new([FrameAt(0, 0), FrameAt(1, 1), FrameAt(2, 200), FrameAt(3, 201)]);
        PeerDriver driver = new(
            link,
            () =>
            {
                made++;
                return new StandingController();
            },
            Ample);
        driver.Run(null, 0.3, default);

        Assert.Equal(2, made);
    }

    [Fact]
    public async Task Run_ends_when_the_game_closes_the_bridge()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        PeerDriver driver = new(link, static () => new StandingController(), Ample);
        game.Say(FakeGame.Frame(1));
        var driving = Task.Run(() => driver.Run(null, 60, default));
        game.Hear();
        Assert.Contains("\"controls\"", game.Hear(), StringComparison.Ordinal);
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
        game.Hear();
        game.Close();

        Assert.ThrowsAny<IOException>(() => new PeerDriver(link, static () => new StandingController(), Ample).Run(null, 60, default));
    }

    private static PeerFrame FrameAt(int number, double x) => new(
        number, number * 0.1, new DrivingState(LaneIndicators.Unknown, LaneIndicators.Unknown, IsFast: false, 10), new Vector3D(x, 0, 0));

    private sealed class StandingController : IController
    {
        public DrivingControls Drive(DrivingState state) => DrivingControls.Stop;
    }

    private sealed class FakeLink(IEnumerable<PeerFrame?> frames) : IPeerLink
    {
        private readonly Queue<PeerFrame?> _frames = new(frames);

        public int Answers { get; private set; }

        public int Steps { get; private set; }

        /// <summary>After so many answers another frame comes.</summary>
        public int NextAfterAnswers { get; init; } = -1;

        public PeerFrame? Receive(TimeSpan patience)
        {
            Thread.Sleep(1);
            return Answers == NextAfterAnswers ? FrameAt(1, 1) : _frames.Count > 0 ? _frames.Dequeue() : null;
        }

        public void Send(DrivingControls controls, long frame) => Answers++;

        public void Step(double seconds) => Steps++;

        public void Dispose()
        {
        }
    }
}
