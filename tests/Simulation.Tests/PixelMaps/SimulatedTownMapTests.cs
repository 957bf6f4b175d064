using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.PixelMaps;

/// <summary>
/// Adaptive maps of the simulated town, whose things are meshes with round wheels, branches and lamps, against exhaustive ones.
/// </summary>
public sealed class SimulatedTownMapTests(ITestOutputHelper output)
{
    private const double RangeMetres = 150;

    public static TheoryData<int> FirstSeeds => [.. ProofSize.Of([100], [0, 100])];

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(FirstSeeds))]
    public void Run_simulated_town_agrees_with_the_exhaustive_maps(int firstSeed)
    {
        const int width = 800;
        const int height = 600;
        var scores = new MapScores();
        for (int moment = 0; moment < 12; moment++)
        {
            int seed = firstSeed + moment;
            double density = 0.2 + (0.1 * moment);
            var game = new SimulatedGame(
                new SimulationOptions
                {
                    Seed = seed,
                    WindowAspect = 4.0 / 3,
                    TrafficDensity = density,
                    PedestrianDensity = density,
                }
            );
            for (int tick = 0; tick < 100 + (moment * 20); tick++)
            {
                game.Tick(0.1);
            }

            CameraState state = game.Ports.World.ReadCamera();
            var camera = new Camera(
                state.Pose,
                new CameraIntrinsics(state.VerticalFovDegrees, new ImageSize(width, height), state.WindowAspect, state.NearClip, Lens.Ideal)
            );
            int ego = game.Ports.World.ReadEgo().Handle;
            List<MapTarget> targets = Targets(camera, game.Ports.World.ReadEntities(state.Pose.Position, RangeMetres), ego);
            Dictionary<int, ushort> numbers = targets.ToDictionary(target => target.Entity, target => target.Number);
            InstanceMap exact = ExhaustivePixelMapper.Map(
                camera,
                camera.Image.Bounds,
                entity => numbers.GetValueOrDefault(entity),
                ego,
                game.Ports.Rays
            );

            var mapper = new AdaptivePixelMapper(camera, targets, ego, game.Ports.Rays, new PixelMapOptions());
            mapper.Run();
            AdaptivePixelMap map = mapper.Finish();
            scores.Add(exact, map.Map, map.RaysCast);
            output.WriteLine($"seed {seed}: {targets.Count} objects, {map.RaysCast} rays");
        }

        output.WriteLine(
            $"large {scores.Large.Count}: mean {scores.Large.Average():F4}, least {scores.Large.Min():F3}, under 0.95: "
                + $"{scores.Large.Count(iou => iou < 0.95)}; "
                + $"medium {scores.Medium.Count}: {scores.Medium.Average():F4}; small {scores.SmallFound.Count}: "
                + $"{scores.SmallFound.Average(found => found ? 1.0 : 0):P1}; "
                + $"rays {scores.MeanRayFraction:P3}, of allowed {scores.MaxFractionOfAllowedRays:F2}"
        );
        Assert.InRange(scores.Large.Average(), 0.99, 1);
        Assert.InRange(scores.Large.Min(), 0.95, 1);
        Assert.InRange(scores.Medium.Average(), 0.97, 1);
        Assert.InRange(scores.SmallFound.Average(found => found ? 1.0 : 0), 0.99, 1);
        Assert.InRange(scores.MeanRayFraction, 0, 0.01);
        Assert.InRange(scores.MaxFractionOfAllowedRays, 0, 1);
    }

    private static List<MapTarget> Targets(Camera camera, IReadOnlyList<EntityState> entities, int ego)
    {
        var targets = new List<MapTarget>();
        foreach (EntityState entity in entities)
        {
            Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
            CuboidProjection projection = CuboidProjector.Project(camera, cuboid);
            if (entity.Handle != ego && projection.Outcome == BoxOutcome.InImage)
            {
                targets.Add(new MapTarget(entity.Handle, (ushort)(targets.Count + 1), cuboid, projection));
            }
        }

        return targets;
    }
}
