using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.TestSupport;

namespace Harvester.Simulation.Tests.Driving;

public sealed class EgoManoeuvreTests
{
    private const double Tick = 0.1;

    /// <summary>Width of the parking strips and shoulders beside lanes in the town, metres.</summary>
    private const double BesideLanes = 2.4;

    /// <summary>A car that drives through a busy town covers more, with all its stops, metres per second.</summary>
    private const double MinSpeed = 1.6;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [Trait("Category", "Heavy")]
    public void Lively_ego_touches_nobody_and_stays_off_the_kerbs(int seed)
    {
        SimulatedGame game = new(Lively(seed) with { TrafficDensity = 2, PedestrianDensity = 3 });
        int seconds = ProofSize.Of(inCi: 80, full: 240);
        double metres = 0;
        Run(
            game,
            seconds,
            () =>
            {
                EgoState ego = game.Ports.World.ReadEgo();
                metres += ego.Velocity.Length * Tick;
                foreach (EntityState other in game.Ports.World.ReadEntities(ego.Pose.Position, 15))
                {
                    bool isBody = VehicleClasses.AreVehicles(other.Class) || other.Class == ObjectClass.Pedestrian;
                    Assert.False(isBody && Touches(ego, other), $"The car touches {other.Model} after {metres:0} m.");
                }

                if (game.Truth.Locate(ego.Pose.Position, ego.Pose.Axes.Forward) is { IsInJunction: false, Lane: not null } at)
                {
                    double edge = at.OncomingLanes == 0 ? at.Lanes * at.LaneWidth / 2 : (at.MedianWidth / 2) + (at.Lanes * at.LaneWidth);
                    Assert.InRange(at.RightOfRoadLine + ego.ModelMax.X, double.NegativeInfinity, edge + BesideLanes);
                }
            }
        );

        Assert.True(metres > MinSpeed * seconds, $"The car has driven only {metres:0} m.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lively_ego_does_everything_and_spreads_over_its_lane()
    {
        HashSet<Manoeuvre> seen = [];
        List<double> offsets = [];
        foreach (int seed in new[] { 4, 5, 6, 11 })
        {
            SimulatedGame game = new(Lively(seed) with { TrafficDensity = 0.5, PedestrianDensity = 0, LaneChanges = 3 });
            Run(
                game,
                60,
                () =>
                {
                    EgoState ego = game.Ports.World.ReadEgo();
                    seen.Add(ego.Motion!.Manoeuvre!.Value);
                    Assert.InRange(ego.Motion.Steering!.Value, -1, 1);
                    if (game.Truth.Locate(ego.Pose.Position, ego.Pose.Axes.Forward) is { IsInJunction: false, Lane: not null } at)
                    {
                        offsets.Add(at.RightOfLaneCentre);
                    }
                }
            );
        }

        double mean = offsets.Average();
        Assert.True(Math.Sqrt(offsets.Average(offset => (offset - mean) * (offset - mean))) > 0.5, "The car keeps to the middle.");
        HashSet<Manoeuvre> expected =
        [
            Manoeuvre.Wander,
            Manoeuvre.Drift,
            Manoeuvre.Recover,
            Manoeuvre.LaneChangeLeft,
            Manoeuvre.LaneChangeRight,
            Manoeuvre.Follow,
        ];
        Assert.Superset(expected, seen);
    }

    [Fact]
    public void Motion_of_the_label_is_that_of_the_poses()
    {
        SimulatedGame game = new(Alone(7));
        EgoState before = game.Ports.World.ReadEgo();
        double turned = 0;
        double gained = 0;
        double speed = before.Velocity.Length;
        const double step = 0.02;
        for (int i = 0; i < 1000; i++)
        {
            game.Tick(step);
            EgoState ego = game.Ports.World.ReadEgo();
            turned += ego.Motion!.YawRate * step;
            gained += ego.Motion.Acceleration * step;
        }

        // The velocity of the label is that of the car's origin, which in a turn also moves sideways, so it is a little faster.
        EgoState after = game.Ports.World.ReadEgo();
        Vector3D was = before.Pose.Axes.Forward;
        Vector3D isNow = after.Pose.Axes.Forward;
        double angle = Math.Atan2((was.X * isNow.Y) - (was.Y * isNow.X), (was.X * isNow.X) + (was.Y * isNow.Y));
        Assert.Equal(0, Math.IEEERemainder(turned - angle, 2 * Math.PI), 1e-6);
        Assert.Equal(after.Velocity.Length - speed, gained, 0.3);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Same_seed_drives_the_same_way_and_another_differs()
    {
        Assert.Equal(Way(8), Way(8));
        Assert.NotEqual(Way(8), Way(9));

        static Vector3D Way(int seed)
        {
            SimulatedGame game = new(Alone(seed));
            Run(game, 20, () => { });
            return game.Ports.World.ReadEgo().Pose.Position;
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Place_has_entities_of_its_own_and_time_goes_on()
    {
        SimulatedGame game = new(Lively(10) with { TrafficDensity = 0.3 });
        Run(game, 1, () => { });
        int greatest = game.Ports.World.ReadEntities(Vector3D.Zero, 5000).Max(entity => entity.Handle);
        double time = game.Ports.World.TimeSeconds;
        long frame = game.Ports.World.GameFrame;
        EnvironmentState environment = game.Ports.World.ReadEnvironment();

        game.GoTo(new Vector2D(250, -125));

        Vector3D place = game.Ports.World.ReadEgo().Pose.Position;
        Assert.Equal(1, game.Place);
        Assert.All(game.Ports.World.ReadEntities(place, 5000), entity => Assert.True(entity.Handle > greatest));
        Assert.True(game.Ports.World.TimeSeconds > time);
        Assert.True(game.Ports.World.GameFrame >= frame);
        Assert.Equal(environment, game.Ports.World.ReadEnvironment());
        Assert.InRange(Horizontal.Distance(place, new Vector3D(250, -125, 0)), 0, 250);
    }

    private static SimulationOptions Lively(int seed) =>
        new()
        {
            Seed = seed,
            Wander = 1,
            LaneChanges = 1,
            IsWarm = true,
        };

    private static SimulationOptions Alone(int seed) => Lively(seed) with { TrafficDensity = 0, PedestrianDensity = 0 };

    private static void Run(SimulatedGame game, double seconds, Action check)
    {
        for (double time = 0; time < seconds; time += Tick)
        {
            game.Tick(Tick);
            check();
        }
    }

    /// <summary>Whether points along the outline of one box, 0.2 m apart, lie in the other, or its centre does.</summary>
    private static bool Touches(EgoState ego, EntityState other) =>
        Outline(ego.ModelMin, ego.ModelMax).Any(point => IsIn(other.Pose.ToLocal(ego.Pose.ToWorld(point)), other.ModelMin, other.ModelMax))
        || IsIn(ego.Pose.ToLocal(other.Pose.ToWorld((other.ModelMin + other.ModelMax) * 0.5)), ego.ModelMin, ego.ModelMax);

    private static IEnumerable<Vector3D> Outline(Vector3D min, Vector3D max)
    {
        const int steps = 24;
        for (int i = 0; i <= steps; i++)
        {
            double x = min.X + ((max.X - min.X) * i / steps);
            double y = min.Y + ((max.Y - min.Y) * i / steps);
            yield return new Vector3D(x, min.Y, 0);
            yield return new Vector3D(x, max.Y, 0);
            yield return new Vector3D(min.X, y, 0);
            yield return new Vector3D(max.X, y, 0);
        }
    }

    private static bool IsIn(Vector3D point, Vector3D min, Vector3D max) =>
        point.X > min.X && point.X < max.X && point.Y > min.Y && point.Y < max.Y && point.Z > min.Z && point.Z < max.Z;
}
