using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Traffic;

public class TrafficTests
{
    [Fact]
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

    private static void AssertApart(IReadOnlyList<Vehicle> vehicles)
    {
        BodyIndex<Vehicle> index = new();
        foreach (Vehicle vehicle in vehicles)
        {
            foreach (Vehicle other in index.Near(vehicle.Pose.Position))
            {
                Assert.False(
                    vehicle.Footprint.Overlaps(other.Footprint),
                    $"{vehicle.Model.Name} and {other.Model.Name} overlap near {vehicle.Pose.Position}.");
            }

            index.Add(vehicle, vehicle.Pose.Position);
        }
    }
}
