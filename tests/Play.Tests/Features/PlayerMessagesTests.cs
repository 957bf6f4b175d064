using Harvester.Play.Features;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Features;

public sealed class PlayerMessagesTests : IDisposable
{
    private readonly TestClock _clock = new();
    private readonly string _folder = Directory.CreateTempSubdirectory("messages").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Tell_shows_and_logs_every_message_even_repeated_ones()
    {
        var shown = new List<string>();
        var messages = new PlayerMessages(_folder, shown.Add, _clock);

        messages.Tell("one");
        messages.Tell("one");
        messages.Tell("two");
        messages.Tell("one");

        Assert.Equal(["GtaDataHarvester: one", "GtaDataHarvester: one", "GtaDataHarvester: two", "GtaDataHarvester: one"], shown);
        messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.Equal(4, File.ReadAllLines(Path.Combine(_folder, "GtaDataHarvester.log")).Length);
    }

    [Fact]
    public void Tell_without_a_folder_to_log_in_still_shows()
    {
        var shown = new List<string>();

        var messages = new PlayerMessages(Path.Combine(_folder, "absent"), shown.Add, _clock);

        messages.Tell("one");

        messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.Single(shown);
    }

    [Fact]
    public void Tell_in_a_game_that_shows_nothing_still_logs()
    {
        var messages = new PlayerMessages(_folder, _ => throw new InvalidOperationException("no screen"), _clock);

        messages.Tell("one");

        messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.EndsWith(" one", File.ReadAllLines(Path.Combine(_folder, "GtaDataHarvester.log"))[0], StringComparison.Ordinal);
    }

    [Fact]
    public void Failures_in_every_tick_are_shown_and_logged_every_5_seconds()
    {
        var shown = new List<string>();
        var messages = new PlayerMessages(_folder, shown.Add, _clock);
        var failure = new InvalidOperationException("no light");

        // 100 ticks of 90 ms: at 0, and at 5040, the first of them after 5 seconds.
        for (int tick = 0; tick < 100; tick++)
        {
            messages.TellFailure("The light", failure);
            messages.TellFailure("The end of the light", failure);
            _clock.Milliseconds += 90;
        }

        string[] both =
        [
            "GtaDataHarvester: The light failed: no light More in GtaDataHarvester.log.",
            "GtaDataHarvester: The end of the light failed: no light More in GtaDataHarvester.log.",
        ];
        Assert.Equal([.. both, .. both], shown);
        messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.Equal(
            4,
            File.ReadAllLines(Path.Combine(_folder, "GtaDataHarvester.log"))
                .Count(line => line.Contains("InvalidOperationException", StringComparison.Ordinal))
        );
    }

    [Fact]
    public void Failure_is_shown_again_after_a_different_message()
    {
        var shown = new List<string>();
        var messages = new PlayerMessages(_folder, shown.Add, _clock);
        var failure = new InvalidOperationException("no light");

        messages.TellFailure("The light", failure);
        messages.TellFailure("The light", failure);
        messages.Tell("The camera is mounted.");
        messages.TellFailure("The light", failure);

        Assert.Equal(3, shown.Count);
        Assert.Equal(shown[0], shown[2]);
        messages.Wait(Timeout.InfiniteTimeSpan);
    }
}
