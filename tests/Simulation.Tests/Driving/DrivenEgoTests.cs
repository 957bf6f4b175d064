using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.Tests.Driving;

public sealed class DrivenEgoTests
{
    private const double Tick = 1.0 / 20;

    [Fact]
    public void Drive_follows_wheel_and_pedals()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, PedestrianDensity = 0 });
        IDrivenCar car = game.Ports.Car!;
        EgoState before = game.Ports.World.ReadEgo();
        Run(game, 2, () => car.Drive(new DrivingControls(0, 1, 0)));
        EgoState after = game.Ports.World.ReadEgo();

        // 4 m/s² for two seconds, less 0.13 of resistance, more or less 0.6 by a slope of 6 % at most.
        Assert.InRange(after.Velocity.Length, 6.5, 9);
        Assert.InRange((after.Pose.Position - before.Pose.Position).Dot(before.Pose.Axes.Forward), 6.5, 9);

        Run(game, 1, () => car.Drive(new DrivingControls(0.3, 0, 0)));
        Assert.True(
            Horizontal.Turn(after.Pose.Axes.Forward, game.Ports.World.ReadEgo().Pose.Axes.Forward) > 0.1,
            "The car did not turn left."
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Stopped_car_stays_and_traffic_stops_behind_without_contact()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 3,
                TrafficDensity = 2,
                PedestrianDensity = 0,
            }
        );
        IDrivenCar car = game.Ports.Car!;
        Run(game, 20, () => { });
        Run(game, 4, () => car.Drive(DrivingControls.Stop));
        Vector3D place = game.Ports.World.ReadEgo().Pose.Position;
        bool isWaitedFor = false;
        for (int seconds = 0; seconds < 30 && !isWaitedFor; seconds++)
        {
            Run(game, 1, Stay);
            isWaitedFor = game.World.Vehicles.Skip(1).Any(IsStandingBehind);
        }

        Assert.True(isWaitedFor, "Nobody had to wait behind the car.");
        Run(game, 3, Stay);
        Assert.Equal(place, game.Ports.World.ReadEgo().Pose.Position);

        void Stay()
        {
            car.Drive(DrivingControls.Stop);
            Assert.DoesNotContain(game.World.Vehicles.Skip(1), other => other.Footprint.Overlaps(game.World.Ego.Footprint));
        }

        bool IsStandingBehind(Vehicle other)
        {
            Vector3D inEgo = game.World.Ego.Pose.ToLocal(other.Pose.Position);
            return other.Speed == 0 && inEgo is { X: > -2 and < 2, Y: > -12 and < -4 };
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Released_ego_returns_to_its_lane_and_drives_on()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 2,
                TrafficDensity = 0.5,
                PedestrianDensity = 0,
            }
        );
        IDrivenCar car = game.Ports.Car!;
        Run(game, 5, () => { });
        Run(game, 0.6, () => car.Drive(new DrivingControls(0.15, 0.5, 0)));
        Run(game, 4, () => { });
        HashSet<int> roads = [];
        double furthest = 0;
        Run(
            game,
            120,
            () =>
            {
                EgoState ego = game.Ports.World.ReadEgo();
                if (game.Truth.Locate(ego.Pose.Position, ego.Pose.Axes.Forward) is { IsInJunction: false } at)
                {
                    roads.Add(at.Road);
                    furthest = Math.Max(furthest, at.Lane is null ? double.PositiveInfinity : Math.Abs(at.RightOfLaneCentre));
                }
            }
        );

        // A driver who aims several metres ahead cuts bends a little.
        const double cutOfBends = 0.6;
        Assert.InRange(furthest, 0.001, cutOfBends);
        Assert.True(roads.Count >= 4, $"The car drove on {roads.Count} roads only.");
    }

    [Fact]
    public void Drive_into_another_vehicle_stops_the_car()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 3,
                TrafficDensity = 1,
                PedestrianDensity = 0,
            }
        );
        IDrivenCar car = game.Ports.Car!;
        Vehicle other = game
            .World.Vehicles.Skip(1)
            .First(vehicle => vehicle.Path.Road is not null && vehicle.Distance > 25 && vehicle.Path.Length - vehicle.Distance > 60);
        Vector3D start = other.Pose.ToWorld(new Vector3D(0, -15, 0));
        car.Reset(start, Angles.HeadingDegrees(other.Pose.Axes.Forward));
        bool touched = false;
        double speedBefore = 0;
        Run(
            game,
            10,
            () =>
            {
                car.Drive(new DrivingControls(0, 1, 0));

                // The other vehicle may move off again within the tick in which it is met.
                touched |= speedBefore > 1 && game.World.Ego.Speed == 0;
                speedBefore = game.World.Ego.Speed;
                bool touches = game.World.Vehicles.Skip(1).Any(vehicle => vehicle.Footprint.Overlaps(game.World.Ego.Footprint));
                touched |= touches;
                Assert.True(!touches || game.World.Ego.Speed == 0, "The car drove on through another.");
            }
        );

        Assert.True(touched, "The car met nobody.");
    }

    [Fact]
    public void Built_in_driver_stops_for_obstacles_outside_its_lane_too()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, PedestrianDensity = 0 });
        Vehicle ego = game.World.Ego;
        game.World.Car.Loosen();
        Pose start = ego.Pose;
        const double wall = 12;
        for (int tick = 0; tick < 200; tick++)
        {
            game.World.Car.Advance(Tick, 2, room => Front() + room > wall);
        }

        // In a twentieth of a second he drives 0.35 m at the 7 m/s that he has after twelve metres at 2 m/s².
        Assert.InRange(Front(), wall - TrafficFlow.Clearance - 0.4, wall - TrafficFlow.Clearance);
        Assert.Equal(0, ego.Speed);

        double Front() => start.ToLocal(ego.Pose.Position).Y + ego.FrontOverhang;
    }

    [Fact]
    public void Reset_places_a_standing_car_on_the_road()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, PedestrianDensity = 0 });
        Run(game, 10, () => { });
        EgoState there = game.Ports.World.ReadEgo();
        Run(game, 10, () => { });

        game.Ports.Car!.Reset(there.Pose.Position + new Vector3D(0, 0, 1), Angles.HeadingDegrees(there.Pose.Axes.Forward));

        EgoState ego = game.Ports.World.ReadEgo();
        const double slopeOfRoad = 0.02;
        Assert.InRange((ego.Pose.Position - there.Pose.Position).Length, 0, slopeOfRoad);
        Assert.True(ego.Pose.Axes.Forward.Dot(there.Pose.Axes.Forward) > 0.9999);
        Assert.Equal(Vector3D.Zero, ego.Velocity);
    }

    [Fact]
    public void SetEnvironment_sets_the_given_values_and_time_continues()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, PedestrianDensity = 0 });
        Run(game, 10, () => { });

        game.Ports.Car!.SetEnvironment("rain", null);
        Assert.Equal(("rain", new TimeSpan(12, 0, 5 * 60)), (game.Ports.World.ReadEnvironment().Weather, RoundedTime(game)));

        game.Ports.Car!.SetEnvironment(null, new TimeSpan(6, 30, 0));
        Assert.Equal(("rain", new TimeSpan(6, 30, 0)), (game.Ports.World.ReadEnvironment().Weather, RoundedTime(game)));

        Run(game, 20, () => { });
        Assert.Equal(new TimeSpan(6, 40, 0), RoundedTime(game));
        Assert.Throws<ArgumentException>(() => game.Ports.Car!.SetEnvironment("raining frogs", null));
    }

    private static TimeSpan RoundedTime(SimulatedGame game) =>
        TimeSpan.FromSeconds(Math.Round(game.Ports.World.ReadEnvironment().TimeOfDay.TotalSeconds));

    private static void Run(SimulatedGame game, double seconds, Action beforeEachTick)
    {
        int ticks = (int)Math.Round(seconds / Tick);
        for (int i = 0; i < ticks; i++)
        {
            beforeEachTick();
            game.Tick(Tick);
        }
    }
}
