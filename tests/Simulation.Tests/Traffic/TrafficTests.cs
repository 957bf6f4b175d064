using Harvester.Geometry;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Traffic;

public class TrafficTests
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Tick_vehicles_never_overlap()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 1 });
        for (int i = 0; i < 150; i++)
        {
            world.Advance(0.1);
            if (i % 10 == 0)
            {
                AssertApart(world.Vehicles);
            }
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Tick_vehicles_stay_in_their_lanes_outside_junctions()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 3 });
        int judged = 0;
        for (int i = 0; i < 20; i++)
        {
            world.Advance(1);
            foreach (Vehicle vehicle in world.Vehicles.Where(vehicle => vehicle.Path.Road is not null))
            {
                LanePosition? position = world.Truth.Locate(vehicle.Pose.Position, vehicle.Pose.Axes.Forward);
                if (position is { IsInJunction: false })
                {
                    judged++;
                    Assert.NotNull(position.Lane);
                    Assert.InRange(position.RightOfLaneCentre, -0.05, 0.05);
                }
            }
        }

        Assert.True(judged > 1000, $"Only {judged} places judged.");
    }

    /// <summary>
    /// A vehicle waits at a light for at most 13 s, and for a queue a few times that. One that stands for 40 s is placed elsewhere: it was
    /// stuck. Nobody can drive on at all where vehicles in a junction wait for each other.
    /// </summary>
    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(8)]
    public void Tick_few_vehicles_get_stuck_in_two_minutes(int seed)
    {
        const double maxOfAll = 0.1;
        const double jumpMetres = 30;
        SimulatedWorld world = new(new SimulationOptions { Seed = seed });
        Vector3D[] before = [.. world.Vehicles.Select(vehicle => vehicle.Pose.Position)];
        double[] stood = new double[before.Length];
        int stuck = 0;
        for (double time = 0; time < 120; time += 0.5)
        {
            world.Advance(0.5);
            for (int i = 0; i < before.Length; i++)
            {
                Vector3D now = world.Vehicles[i].Pose.Position;
                stuck += (now - before[i]).Length > jumpMetres && stood[i] > 10 ? 1 : 0;
                stood[i] = now == before[i] ? stood[i] + 0.5 : 0;
                before[i] = now;
            }
        }

        Assert.True(stuck < maxOfAll * before.Length, $"{stuck} of {before.Length} vehicles got stuck.");
    }

    private static void AssertApart(IReadOnlyList<Vehicle> vehicles)
    {
        BodyIndex<Vehicle> index = new();
        foreach (Vehicle vehicle in vehicles)
        {
            foreach (Vehicle other in index.Near(vehicle.Pose.Position))
            {
                Assert.False(
                    vehicle.Footprint.Overlaps(other.Footprint),
                    $"{vehicle.Model.Name} and {other.Model.Name} overlap near {vehicle.Pose.Position}."
                );
            }

            index.Add(vehicle, vehicle.Pose.Position);
        }
    }
}
