using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Traffic;

/// <summary>The velocities of people on foot against the way that they go.</summary>
public sealed class WalkerVelocityTests(ITestOutputHelper output)
{
    private const double TickSeconds = 0.01;

    /// <summary>
    /// The mean of the velocities before and after a tick is that of its way, except for what the acceleration changes within the tick.
    /// </summary>
    private const double Tolerance = 0.005;

    /// <summary>
    /// Someone steps off a kerb, sets off, stops, turns round or comes to another bend within a tick, in which the velocity jumps.
    /// </summary>
    private const double MaxSteps = 0.002;

    [Theory]
    [InlineData(3)]
    [InlineData(15)]
    [Trait("Category", "Heavy")]
    public void Velocity_is_displacement_per_tick_time(int seed)
    {
        SimulatedWorld world = new(
            new SimulationOptions
            {
                Seed = seed,
                TrafficDensity = 0.1,
                PedestrianDensity = 3,
            }
        );
        List<double> errors = [];
        int climbs = 0;
        Dictionary<int, EntityState> before = Walkers(world).ToDictionary(walker => walker.Handle);
        for (int tick = 0; tick < 300; tick++)
        {
            world.Advance(TickSeconds);
            foreach (EntityState walker in Walkers(world))
            {
                EntityState earlier = before[walker.Handle];
                Vector3D way = (walker.Pose.Position - earlier.Pose.Position) / TickSeconds;
                errors.Add((((earlier.Velocity + walker.Velocity) / 2) - way).Length);
                climbs += Math.Abs(way.Z) > Tolerance ? 1 : 0;
                before[walker.Handle] = walker;
            }
        }

        errors.Sort();
        int off = errors.Count(error => error > Tolerance);
        output.WriteLine(
            $"{errors.Count} velocities, {climbs} of them up or down; median error {errors[errors.Count / 2]:F5} m/s, {off} of more than "
                + $"{Tolerance} m/s, greatest {errors[^1]:F3} m/s"
        );
        Assert.True(errors.Count > 10_000 && climbs > 1_000, $"{errors.Count} velocities, {climbs} of them up or down.");
        Assert.True(off <= MaxSteps * errors.Count, $"{off} of {errors.Count} velocities are more than {Tolerance} m/s off.");
    }

    private static IEnumerable<EntityState> Walkers(SimulatedWorld world) =>
        world.EntitiesNear(Vector3D.Zero, double.PositiveInfinity).Where(entity => entity.Class == ObjectClass.Pedestrian);
}
