using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Traffic;

/// <summary>What traffic does at the lights and stop signs that stand at the end of its lanes.</summary>
public sealed class RightOfWayTests
{
    private const double Tick = 0.1;
    private const string StopSign = "prop_sign_road_01a";
    private const string LightAtLine = "prop_traffic_03a";

    /// <summary>Metres from the end of a lane, along it, within which its own sign or light stands: at most 7.5 m before it.</summary>
    private const double Along = 8;

    /// <summary>Metres beside the end of a lane within which its own sign or light stands: three lanes and the kerb.</summary>
    private const double Beside = 22;

    /// <summary>Metres from a vehicle's front to the end of its lane within which it has stopped there, with one tick of driving.</summary>
    private const double AtLine = 3.1;

    /// <summary>Metres per second below which a vehicle has stopped.</summary>
    private const double Standing = 0.3;

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(1)]
    [InlineData(8)]
    public void No_vehicle_passes_a_red_light(int seed)
    {
        Dictionary<LightState, int> passed = [];
        SimulatedWorld world = new(new SimulationOptions { Seed = seed });
        Watch(
            world,
            (vehicle, lane) =>
            {
                if (At(lane, world, LightAtLine) is { } light)
                {
                    LightState state = world.LightAt(light.Handle, world.TimeSeconds)!.Value;
                    passed[state] = passed.GetValueOrDefault(state) + 1;
                }
            }
        );

        int atGreen = passed.GetValueOrDefault(LightState.Green);
        Assert.True(atGreen > 100, $"Only {atGreen} passed at green.");
        Assert.Equal(0, passed.GetValueOrDefault(LightState.Red));
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(1)]
    [InlineData(8)]
    public void Every_vehicle_stops_at_a_stop_sign(int seed)
    {
        int stopped = 0;
        int passed = 0;
        SimulatedWorld world = new(new SimulationOptions { Seed = seed });
        Dictionary<Vehicle, LanePath> stoppedOn = [];
        Watch(
            world,
            (vehicle, lane) =>
            {
                if (At(lane, world, StopSign) is not null)
                {
                    _ = stoppedOn.GetValueOrDefault(vehicle) == lane ? stopped++ : passed++;
                }
            },
            vehicle =>
            {
                if (vehicle.Speed < Standing && vehicle.Path.Length - vehicle.Distance - vehicle.FrontOverhang < AtLine)
                {
                    stoppedOn[vehicle] = vehicle.Path;
                }
            }
        );

        Assert.True(stopped > 20, $"Only {stopped} vehicles stopped.");
        Assert.Equal(0, passed);
    }

    /// <summary>Lets two minutes pass and tells of each vehicle that drives from the end of a lane into a junction.</summary>
    private static void Watch(SimulatedWorld world, Action<Vehicle, LanePath> enter, Action<Vehicle>? look = null)
    {
        const double seconds = 120;
        Dictionary<Vehicle, LanePath> before = [];
        for (int i = 0; i < seconds / Tick; i++)
        {
            world.Advance(Tick);
            foreach (Vehicle vehicle in world.Vehicles)
            {
                if (before.GetValueOrDefault(vehicle) is { Road: not null } lane && vehicle.Path.Previous.Contains(lane))
                {
                    enter(vehicle, lane);
                }

                before[vehicle] = vehicle.Path;
                look?.Invoke(vehicle);
            }
        }
    }

    private static EntityState? At(LanePath lane, SimulatedWorld world, string name)
    {
        (Vector3D end, Vector3D tangent) = lane.Line.At(lane.Length);
        return world
            .EntitiesNear(end, Along + Beside)
            .Find(entity =>
                entity.Model == name
                && entity.Pose.Axes.Forward.Dot(tangent) > 0.9
                && Math.Abs((entity.Pose.Position - end).Dot(tangent)) < Along
                && (entity.Pose.Position - end).Dot(Horizontal.RightOf(tangent)) is > 0 and < Beside
            );
    }
}
