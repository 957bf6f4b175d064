using System.Text;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Plans;

namespace Harvester.Cli.Tests.Supervising;

/// <summary>What is wrong with a series of heartbeats, without processes and clocks.</summary>
public sealed class HeartbeatJudgeTests
{
    private const int Own = 7;

    private static readonly DateTime Noon = new(2026, 1, 2, 12, 0, 0, DateTimeKind.Utc);

    private readonly Progress _progress = new();
    private readonly HeartbeatJudge _judge;

    public HeartbeatJudgeTests() => _judge = Judge(HeartbeatReading.Missing);

    [Fact]
    public void Heartbeats_with_new_frames_are_fine()
    {
        for (int second = 0; second < 1000; second++)
        {
            Assert.Null(At(second, Beat(second, second)));
        }
    }

    [Fact]
    public void Heartbeat_that_stops_is_a_hang()
    {
        At(0, Beat(0, 1));

        Assert.Null(At(10, Beat(0, 1)));
        Assert.Equal("no new heartbeat for 10 s", At(10.1, Beat(0, 1)));
    }

    [Fact]
    public void Time_that_goes_back_is_no_new_heartbeat()
    {
        At(0, Beat(20, 1));
        At(5, Beat(19, 2));

        Assert.Equal("no new heartbeat for 10 s", At(10.1, Beat(18, 3)));
    }

    [Fact]
    public void Clock_that_is_set_back_does_not_matter()
    {
        At(0, Beat(0, 1));

        Assert.Null(_judge.Judge(Beat(5, 2), TimeSpan.FromSeconds(5), Noon.AddSeconds(-20), id => id == Own));
    }

    [Fact]
    public void Frames_that_stay_are_a_stall_while_it_is_running()
    {
        for (int second = 0; second <= 30; second++)
        {
            Assert.Null(At(second, Beat(second, 4)));
        }

        Assert.Equal("its heartbeat goes on, but it has been at frame 4 for 30 s", At(31, Beat(31, 4)));
    }

    [Fact]
    public void New_trial_is_progress_without_frames()
    {
        for (int second = 0; second < 100; second++)
        {
            Assert.Null(At(second, Beat(second, 4, trial: $"trial {second / 20}")));
        }
    }

    [Fact]
    public void Start_has_a_patience_of_its_own()
    {
        for (int second = 0; second <= 50; second++)
        {
            Assert.Null(At(second, Beat(second, 0, HeartbeatState.Starting)));
        }

        Assert.Equal("still starting after 50 s", At(51, Beat(51, 0, HeartbeatState.Starting)));
    }

    [Fact]
    public void Each_trial_may_start_anew()
    {
        At(0, Beat(0, 0, HeartbeatState.Starting));
        At(40, Beat(40, 1));

        Assert.Null(At(60, Beat(41, 1, HeartbeatState.Starting)));
        Assert.Null(At(109, Beat(90, 1, HeartbeatState.Starting)));
        Assert.Equal("still starting after 50 s", At(111, Beat(111, 1, HeartbeatState.Starting)));
    }

    [Fact]
    public void Trials_that_do_not_load_in_a_row_are_no_hang()
    {
        for (int second = 0; second <= 200; second++)
        {
            Assert.Null(At(second, Beat(second, 0, HeartbeatState.Starting, trial: $"trial {second / 40}")));
        }
    }

    [Fact]
    public void Heartbeat_that_never_comes_is_a_hang()
    {
        Assert.Null(At(50, HeartbeatReading.Missing));
        Assert.Equal("no heartbeat within 50 s", At(50.1, HeartbeatReading.Missing));
    }

    [Fact]
    public void File_of_an_earlier_start_is_not_heard()
    {
        HeartbeatReading former = Beat(-100, 50, HeartbeatState.Finished, process: 3);
        HeartbeatJudge judge = Judge(former);

        Assert.Null(judge.Judge(former, TimeSpan.FromSeconds(1), Noon, id => id == Own));
        Assert.Null(judge.Last);
        Assert.Equal(
            "its heartbeat names process 3, which the command did not start",
            judge.Judge(Beat(1, 51, process: 3), TimeSpan.FromSeconds(2), Noon, id => id == Own)
        );
    }

    [Fact]
    public void Heartbeat_from_the_future_is_a_lie()
    {
        Assert.Null(At(0, Beat(30, 1)));
        Assert.Equal("its heartbeat is 31 s in the future", At(1, Beat(32, 1)));
    }

    [Theory]
    [InlineData("finished")]
    [InlineData("failed")]
    public void Process_that_goes_on_after_its_end_is_a_lie(string name)
    {
        HeartbeatState state = Enum.Parse<HeartbeatState>(name, ignoreCase: true);
        At(0, Beat(0, 1, state));

        Assert.Null(At(10, Beat(10, 1, state)));
        Assert.Equal($"its heartbeat says {name}, but the process goes on", At(11, Beat(11, 1, state)));
    }

    [Fact]
    public void Progress_is_a_new_trial_or_more_frames_than_ever()
    {
        At(0, Beat(0, 5, trial: "a"));
        Assert.True(_progress.Take());
        Assert.False(_progress.Take());

        At(1, Beat(1, 3, trial: "a"));
        Assert.False(_progress.Take());

        At(2, Beat(2, 0, trial: "b"));
        Assert.True(_progress.Take());
        Assert.Equal(5, _progress.Frames);
    }

    private HeartbeatJudge Judge(HeartbeatReading before) =>
        new(
            new SupervisorOptions
            {
                Program = "game",
                Arguments = [],
                HeartbeatPath = "heartbeat.json",
                Timeout = TimeSpan.FromSeconds(10),
                StartTimeout = TimeSpan.FromSeconds(50),
                Stall = TimeSpan.FromSeconds(30),
            },
            before,
            _progress
        );

    private string? At(double seconds, HeartbeatReading reading) =>
        _judge.Judge(reading, TimeSpan.FromSeconds(seconds), Noon.AddSeconds(seconds), id => id == Own);

    private static HeartbeatReading Beat(
        double seconds,
        long frames,
        HeartbeatState state = HeartbeatState.Running,
        string trial = "",
        int process = Own
    )
    {
        var heartbeat = new SeenHeartbeat(process, Noon.AddSeconds(seconds), state, trial, frames);
        return new HeartbeatReading(Encoding.UTF8.GetBytes(heartbeat.ToString()), heartbeat, null);
    }
}
