using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.World;

public class SitesTests
{
    [Fact]
    public void Worlds_of_one_seed_share_their_site()
    {
        Assert.Same(Sites.Town(41), Sites.Town(41));
        Assert.NotSame(Sites.Town(41), Sites.Town(42));
    }

    [Fact]
    public void Site_not_used_recently_is_released()
    {
        Site first = Sites.Town(51);
        foreach (int other in Enumerable.Range(52, 3))
        {
            Sites.Town(other);
        }

        Assert.NotSame(first, Sites.Town(51));
    }

    [Fact]
    public void Worlds_on_a_shared_site_are_independent()
    {
        var options = new SimulationOptions { Seed = 43 };
        byte[] alone = PictureAfterTicks(new SimulatedGame(options));
        var driven = new SimulatedGame(options);
        driven.Ports.Car!.Reset(driven.Shown.Ego.Pose.Position, 0);
        PictureAfterTicks(driven);
        Assert.Equal(alone, PictureAfterTicks(new SimulatedGame(options)));
    }

    private static byte[] PictureAfterTicks(SimulatedGame game)
    {
        for (int tick = 0; tick < 120; tick++)
        {
            game.Tick(1 / 60.0);
        }

        return [.. game.Render(new ImageSize(160, 120)).Colour];
    }
}
