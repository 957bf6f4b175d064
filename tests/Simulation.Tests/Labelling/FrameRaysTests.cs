using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>The rays that labels report, compared with those cast in the game.</summary>
public sealed class FrameRaysTests
{
    private const int PlentyOfRays = 100_000;

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    [Trait("Category", "Heavy")]
    public void Rays_of_every_phase_are_reported_and_bounded(bool masks)
    {
        RayCounts[] all = Harvest(masks, PlentyOfRays);
        Assert.Contains(all, rays => rays is { Occlusion: > 0, Faces: > 0, IgnoreRegions: > 0, Lanes: > 0 } && rays.Map > 0 == masks);

        int budget = all.Min(rays => rays.Total) / 2;
        Assert.All(Harvest(masks, budget), rays => Assert.InRange(rays.Total, 1, budget));
    }

    private static RayCounts[] Harvest(bool masks, int budget)
    {
        List<RayCounts> reported = [];
        var game = new SimulatedGame(new SimulationOptions { Seed = 15 });
        var counted = new CountedRays(game.Ports.Rays);
        GamePorts ports = game.Ports with { Rays = counted, Roads = new FixedRoads(game.Roads, "simulation") };
        var options = new HarvestOptions
        {
            Image = new ImageSize(400, 300),
            MaxFrames = 3,
            RateHz = 0.25,
            Masks = masks,
            RayBudget = budget,
        };
        LabelledTown.Harvest(game, ports, options, (frame, _) => reported.Add(frame.Label.Rays!));
        Assert.Equal(counted.Count, reported.Sum(rays => rays.Total));
        return [.. reported];
    }

    private sealed class CountedRays(IRayCaster rays) : IRayCaster
    {
        public int Count { get; private set; }

        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
        {
            Count++;
            return rays.Cast(ray, maxDistance, ignoredEntity);
        }
    }
}
