using System.Windows.Forms;
using Harvester.Play.Tapes;
using Xunit.Abstractions;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>A recording ends by itself, and the mod goes on whatever happens to it.</summary>
public sealed class RecordingTests(ITestOutputHelper output)
{
    /// <summary>At 60 ticks a second.</summary>
    private const int TicksOfAMinute = 3600;

    /// <summary>The bound of docs/tape.md.</summary>
    private const int MaxBytesOfAMinute = 20_000_000;

    /// <summary>A game that is hardly asked for anything would prove nothing.</summary>
    private const int MinCallsOfAMinute = 100_000;

    [Fact]
    public void Recording_ends_at_its_time_limit_with_a_message()
    {
        using var driver = new ScriptDriver("[Tape]\nRecord = Natives\nMinutes = 0.5\n");
        driver.Tick(3);
        driver.Clock.Milliseconds = 30_000;
        driver.Tick(3);
        driver.WaitForDisk();

        Assert.Contains("A tape is being recorded for 0.5 minutes", driver.Game.Notifications[0], StringComparison.Ordinal);
        Assert.Contains("The recording ended after 0.5 minutes", driver.Game.Notifications[^1], StringComparison.Ordinal);
        var reader = new TapeReader(new MemoryStream(RecordedGame.TapeOf(driver)));
        TapeEntry[] entries = [.. reader.Entries()];
        Assert.Equal(4, entries.Count(entry => entry is TapeTick));
        Assert.IsType<TapeEnd>(entries[^1]);
        Assert.Null(RecordedGame.Play(RecordedGame.TapeOf(driver)).Difference);
    }

    [Fact]
    public void Disk_that_refuses_the_tape_ends_the_recording_alone()
    {
        using var driver = new ScriptDriver("[Tape]\nRecord = Natives\n");
        File.WriteAllText(driver.Output, "a file in the place of the folder");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.UntilMessage("The tape cannot be written");
        driver.Tick();

        Assert.NotEmpty(driver.Game.Rectangles);
    }

    [Fact]
    public void Nothing_is_recorded_by_default()
    {
        using var driver = new ScriptDriver();
        driver.Tick();
        driver.Script.RaiseAborted();
        driver.WaitForDisk();

        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Minute_without_pictures_takes_less_than_20_MB() => AssertSmall(TicksOfAMinute);

    /// <summary>Records a harvest that never stops, for some ticks.</summary>
    private void AssertSmall(int ticks)
    {
        byte[] tape = RecordedGame.Harvest(RecordedGame.Options, ticks: ticks);
        int calls = new EditedTape(tape).Entries.Count(entry => entry is TapeCall);

        output.WriteLine($"{ticks} ticks, {tape.Length} bytes, {calls} calls");
        Assert.InRange(calls, MinCallsOfAMinute * ticks / TicksOfAMinute, int.MaxValue);
        Assert.InRange(tape.Length, 0, MaxBytesOfAMinute * (long)ticks / TicksOfAMinute);
    }
}
