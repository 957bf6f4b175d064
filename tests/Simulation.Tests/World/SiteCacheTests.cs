using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.World;

public class SiteCacheTests
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Worlds_of_one_seed_share_a_site_until_it_is_released()
    {
        var sites = new SiteCache();
        Site first = sites.Town(51);
        Assert.Same(first, sites.Town(51));
        foreach (int other in Enumerable.Range(52, 3))
        {
            Assert.NotSame(first, sites.Town(other));
        }

        Assert.NotSame(first, sites.Town(51));
    }

    [Fact]
    [Trait("Category", "Heavy")]
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
        for (int tick = 0; tick < 40; tick++)
        {
            game.Tick(1 / 60.0);
        }

        return [.. game.Render(new ImageSize(160, 120)).Colour];
    }
}
