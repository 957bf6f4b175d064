using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.Tests.Driving;

public sealed class EgoConductTests
{
    private const double Tick = 0.05;
    private static readonly DrivingControls Ahead = new(0, 0.5, 0);

    [Fact]
    public void Distance_is_that_of_the_car()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, PedestrianDensity = 0 });
        _ = game.Conduct;
        game.Tick(Tick);
        double before = game.Conduct.Metres;
        double way = 0;
        for (int i = 0; i < 400; i++)
        {
            Vector3D place = game.Ports.World.ReadEgo().Pose.Position;
            game.Tick(Tick);
            way += (game.Ports.World.ReadEgo().Pose.Position - place).Length;
        }

        Assert.True(way > 50, $"{way} m");
        Assert.Equal(way, game.Conduct.Metres - before, 6);
    }

    [Fact]
    public void Collision_with_a_parked_vehicle_counts_once()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 2,
                TrafficDensity = 0,
                ParkedDensity = 1,
                PedestrianDensity = 0,
            }
        );
        EntityState parked = game
            .Ports.World.ReadEntities(game.Ports.World.ReadEgo().Pose.Position, 500)
            .First(entity => entity.Class == ObjectClass.Car && entity.Velocity == default);

        // 12 m behind its middle, so that some 7 m are free between two cars.
        Vector3D place = parked.Pose.Position - (parked.Pose.Axes.Forward * 12);
        game.Ports.Car!.Reset(place, Angles.HeadingDegrees(parked.Pose.Axes.Forward));
        bool wasFree = game.Conduct.Contact is null;
        Drive(game, 6, Ahead);

        Assert.True(wasFree);
        Assert.Equal(EgoContact.Parked, game.Conduct.Contact);
        Assert.Equal([0, 1, 0], game.Conduct.Collisions);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Light_that_a_program_passes_counts_only_if_it_is_red()
    {
        HashSet<LightState> passed = [];
        for (int start = 1; start < 20 && passed.Count < 2; start++)
        {
            SimulatedGame game = Find(
                conduct => conduct is { Light: LightState.Red or LightState.Green, MetresToTurn: > 2 and < 8 },
                start
            );
            LightState before = LightState.Unknown;
            for (int tick = 0; tick < 200 && game.Conduct.MetresToTurn > 0; tick++)
            {
                before = game.Conduct.Light ?? before;
                Drive(game, Tick, new DrivingControls(0, 1, 0));
            }

            // A light that changes while the car passes it may be of either colour.
            if (before is LightState.Red or LightState.Green)
            {
                Assert.Equal(before == LightState.Red ? 1 : 0, game.Conduct.RedLightsRun);
                Assert.Null(game.Conduct.Light);
                passed.Add(before);
            }
        }

        Assert.Equal(2, passed.Count);
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(0, 1)]
    [InlineData(3, 0)]
    public void Stop_sign_counts_unless_the_car_has_stopped(double secondsOfBraking, int run)
    {
        SimulatedGame game = Find(conduct => conduct is { HasStopSign: true, MetresToTurn: > 7 and < 9 }, 1);
        Drive(game, secondsOfBraking, DrivingControls.Stop);
        Drive(game, 8, Ahead);

        Assert.Equal((run, 0), (game.Conduct.StopSignsRun, game.Conduct.RedLightsRun));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Built_in_driver_runs_no_red_light_and_hits_nobody()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 1,
                TrafficDensity = 0.5,
                PedestrianDensity = 0,
            }
        );
        _ = game.Conduct;
        bool hasSeenRed = false;
        for (int i = 0; i < 3000; i++)
        {
            game.Tick(Tick);
            hasSeenRed |= game.Conduct is { Light: LightState.Red, MetresToTurn: < 10 };
        }

        Assert.True(hasSeenRed);
        Assert.Equal(0, game.Conduct.RedLightsRun);
        Assert.Equal([0, 0, 0], game.Conduct.Collisions);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Announced_turns_are_those_that_the_car_takes()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 1,
                TrafficDensity = 0,
                PedestrianDensity = 0,
            }
        );
        _ = game.Conduct;
        HashSet<RouteTurn> seen = [];
        for (int junctions = 0; junctions < 25; junctions++)
        {
            Until(game, conduct => conduct.MetresToTurn is > 0 and < 5);
            RouteTurn announced = game.Conduct.Turn!.Value;
            Vector3D before = game.Ports.World.ReadEgo().Pose.Axes.Forward;
            Until(game, conduct => conduct.MetresToTurn == 0);
            Until(game, conduct => conduct.MetresToTurn is not 0);
            double turn = Horizontal.Turn(before, game.Ports.World.ReadEgo().Pose.Axes.Forward);

            // Straight is up to 0.6 rad; the car is not quite parallel to its lane at either end.
            const double slack = 0.15;
            Assert.True(
                announced switch
                {
                    RouteTurn.Left => turn > 0.6 - slack,
                    RouteTurn.Right => turn < -0.6 + slack,
                    _ => Math.Abs(turn) < 0.6 + slack,
                },
                $"{announced} was announced and {turn:0.00} rad driven"
            );
            seen.Add(announced);
        }

        Assert.Equal(3, seen.Count);
    }

    [Fact]
    public void Random_starts_differ_and_repeat()
    {
        int[] seeds = [1, 2, 1];
        Vector3D[] places = [.. seeds.Select(seed => new SimulatedGame(
                    new SimulationOptions
                    {
                        StartSeed = seed,
                        TrafficDensity = 0,
                        PedestrianDensity = 0,
                    }
                ).Ports.World.ReadEgo().Pose.Position)];

        Assert.True((places[0] - places[1]).Length > 20);
        Assert.Equal(places[0], places[2]);
    }

    [Fact]
    public void Traffic_out_of_reach_stands_still()
    {
        const double radius = 100;
        SimulatedGame game = new(
            new SimulationOptions
            {
                TrafficDensity = 1,
                PedestrianDensity = 1,
                TrafficRadiusMetres = radius,
            }
        );
        Vector3D ego = game.Ports.World.ReadEgo().Pose.Position;
        Dictionary<int, Vector3D> before = Places();
        for (int i = 0; i < 40; i++)
        {
            game.Ports.Car!.Drive(DrivingControls.Stop);
            game.Tick(Tick);
        }

        Dictionary<int, Vector3D> after = Places();
        ILookup<bool, int> moved = before
            .Keys.Where(handle => after[handle] != before[handle])
            .ToLookup(handle => Horizontal.Distance(before[handle], ego) <= radius);
        Assert.Empty(moved[false]);
        Assert.NotEmpty(moved[true]);

        Dictionary<int, Vector3D> Places() =>
            game.Ports.World.ReadEntities(ego, 2000).ToDictionary(entity => entity.Handle, entity => entity.Pose.Position);
    }

    /// <summary>A game in which the built-in driver has driven to a place that a condition describes.</summary>
    private static SimulatedGame Find(Func<EgoConduct, bool> condition, int firstStart)
    {
        for (int start = firstStart; start < firstStart + 10; start++)
        {
            SimulatedGame game = new(
                new SimulationOptions
                {
                    Seed = 1,
                    StartSeed = start,
                    TrafficDensity = 0,
                    ParkedDensity = 0,
                    PedestrianDensity = 0,
                }
            );
            _ = game.Conduct;
            for (int tick = 0; tick < 4000; tick++)
            {
                if (condition(game.Conduct) && game.Ports.World.ReadEgo().Velocity.Length > 1)
                {
                    return game;
                }

                game.Tick(Tick);
            }
        }

        throw new InvalidOperationException("No such place was found.");
    }

    private static void Until(SimulatedGame game, Func<EgoConduct, bool> condition)
    {
        for (int i = 0; i < 8000 && !condition(game.Conduct); i++)
        {
            game.Tick(Tick);
        }

        Assert.True(condition(game.Conduct), "It did not come to that.");
    }

    private static void Drive(SimulatedGame game, double seconds, DrivingControls controls)
    {
        for (int i = 0; i < seconds / Tick; i++)
        {
            game.Ports.Car!.Drive(controls);
            game.Tick(Tick);
        }
    }
}
