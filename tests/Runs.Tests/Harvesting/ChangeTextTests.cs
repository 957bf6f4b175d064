using Harvester.Runs.Harvesting;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Tests.Harvesting;

public sealed class ChangeTextTests
{
    [Fact]
    public void Changes_are_read()
    {
        IReadOnlyList<TimedChange>? changes = ChangeText.Read(
            "frame 20: ego brakes 6; 12.5s: 17 brakes 3.5 for 8; frame 0: 4 drives 15; 3 s: without 17; frame_2:_weather_rain"
        );

        Assert.NotNull(changes);
        Assert.Equal([20, null, 0, null, 2], changes.Select(change => change.Frame));
        Assert.Equal([null, 12.5, null, 3, null], changes.Select(change => change.Seconds));
        Assert.Equal([null, 17, 4, 17, null], changes.Select(change => change.Id));
        Assert.Equal(
            [
                new WorldChange(WorldChangeKind.Brake) { Value = 6 },
                new WorldChange(WorldChangeKind.Brake) { Value = 3.5, Seconds = 8 },
                new WorldChange(WorldChangeKind.Drive) { Value = 15 },
                new WorldChange(WorldChangeKind.Remove),
                new WorldChange(WorldChangeKind.Weather) { Weather = "rain" },
            ],
            changes.Select(change => change.Change)
        );
    }

    [Fact]
    public void Actors_and_events_of_scenarios_are_read_by_name()
    {
        IReadOnlyList<TimedChange>? changes = ChangeText.Read(
            "at cut: other brakes 3 for 8; at 2nd: without child-2; frame 1: egon drives 5"
        );

        Assert.NotNull(changes);
        Assert.Equal(["cut", "2nd", null], changes.Select(change => change.Event));
        Assert.Equal(["other", "child-2", "egon"], changes.Select(change => change.Actor));
        Assert.All(changes, change => Assert.Null(change.Id));
    }

    [Theory]
    [InlineData("")]
    [InlineData("ego brakes 6")]
    [InlineData("frame -1: ego brakes 6")]
    [InlineData("frame 99999999999: ego brakes 6")]
    [InlineData("frame 1: ego brakes 0")]
    [InlineData("frame 1: ego brakes 9.1")]
    [InlineData("frame 1: ego brakes 1.2.3")]
    [InlineData("frame 1: ego drives 61")]
    [InlineData("frame 1: ego drives 5 for 3")]
    [InlineData("frame 1: without ego")]
    [InlineData("at : ego brakes 6")]
    [InlineData("at cut ego brakes 6")]
    [InlineData("frame 1: 2nd brakes 6")]
    [InlineData("frame 1: weather sunny")]
    [InlineData("frame 1: ego brakes 6;")]
    [InlineData("frame 1: ego brakes 6\n")]
    public void Other_text_is_not(string text) => Assert.Null(ChangeText.Read(text));
}
