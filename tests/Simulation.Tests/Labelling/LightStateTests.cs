using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>The states of traffic lights that the simulation reports, compared with those read from its pictures.</summary>
public sealed class LightStateTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(5, true)]
    [InlineData(4, true)]
    [InlineData(4, false)]
    [Trait("Category", "Heavy")]
    public void State_of_every_head_is_the_one_in_the_picture(int seed, bool freeze)
    {
        (Dictionary<(int Frame, int Id), LightLabel> set, _) = Harvest(seed, freeze, ports => ports);
        (Dictionary<(int Frame, int Id), LightLabel> read, int fromOtherSides) = Harvest(
            seed,
            freeze,
            ports => ports with { Lights = null }
        );
        (LightState Set, LightState Read)[] both =
        [
            .. read.Where(head => head.Value.Method == LightMethod.Observed).Select(head => (set[head.Key].State, head.Value.State)),
        ];

        output.WriteLine(
            $"{set.Count} heads, {set.Values.Count(head => head.State == LightState.Unknown)} unknown, {fromOtherSides} not from the "
                + $"front; {both.Length} read"
        );
        Assert.True(both.Length > 15, $"Only {both.Length} heads could be read.");
        Assert.True(both.Select(head => head.Read).Distinct().Count() > 1, "All lights show the same.");
        Assert.All(both, head => Assert.Equal(head.Read, head.Set));
        Assert.Equal(set.Keys.Order(), read.Keys.Order());
        if (freeze)
        {
            Assert.All(set.Values, head => Assert.Equal(LightMethod.Set, head.Method));
        }
    }

    private static (Dictionary<(int Frame, int Id), LightLabel> Heads, int FromOtherSides) Harvest(
        int seed,
        bool freeze,
        Func<GamePorts, GamePorts> change
    )
    {
        var heads = new Dictionary<(int, int), LightLabel>();
        int fromOtherSides = 0;
        var options = new HarvestOptions
        {
            Image = new ImageSize(1280, 720),
            MaxFrames = 12,
            RateHz = 0.5,
            Freeze = freeze,
            LiveLag = freeze ? null : new PictureLag(0, 0),
            Classes = [ObjectClass.TrafficLight],
        };
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = seed,
                Weather = "clouds",
                WindowAspect = 16 / 9.0,
            }
        );
        LabelledTown.Harvest(
            game,
            change(game.Ports),
            options,
            (frame, _) =>
            {
                foreach (ObjectLabel head in frame.Label.Objects.Where(item => item.Face?.Light is not null))
                {
                    heads.Add((frame.Label.Frame, head.Id), head.Face!.Light!);
                    fromOtherSides += head.Face.FacesCamera ? 0 : 1;
                }
            }
        );
        return (heads, fromOtherSides);
    }
}
