using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Traffic;
using Harvester.TestSupport;

namespace Harvester.Simulation.Tests.Crashes;

/// <summary>Crashes in the world of the simulated game.</summary>
public sealed class CrashWorldTests
{
    private const double Tick = 1.0 / 60;
    private static readonly DrivingControls FullThrottle = new(0, 1, 0);

    [Fact]
    public void Ego_pushes_a_parked_car_and_reports_it_in_its_tick()
    {
        SimulatedGame game = Game(seed: 2, parked: 1);
        EntityState parked = ParkedCar(game);
        game.Ports.Car!.Reset(parked.Pose.Position - (parked.Pose.Axes.Forward * 12), Angles.HeadingDegrees(parked.Pose.Axes.Forward));
        _ = game.Conduct;
        (Impact impact, EgoState before) = DriveUntilImpact(game, 6);
        EgoState after = game.Ports.World.ReadEgo();

        Assert.Equal([0, 1, 0], game.Conduct.Collisions);
        Assert.Equal(EgoContact.Parked, game.Conduct.Contact);
        Assert.Equal(new[] { before.Handle, parked.Handle }.Order(), new[] { impact.First, impact.Second }.Order());

        // The change of the ego's velocity is the impulse by its mass, and at most the friction of its tyres for a tick.
        Vector2D impulse = impact.First == before.Handle ? impact.Impulse * -1 : impact.Impulse;
        Vector3D change = after.Velocity - before.Velocity;
        Vector2D byImpulse = impulse * (1 / VehicleMass.Of(game.World.Ego.Model));
        double friction = (8 + 4) * Tick;
        Assert.True((new Vector2D(change.X, change.Y) - byImpulse).Length < friction, $"{change} is not {byImpulse}.");
        Assert.True(byImpulse.Length > 1, $"The impact is one of {byImpulse.Length} m/s.");

        // The motion that the ego's sensors report has the impact, too.
        Assert.Equal(change.Dot(before.Pose.Axes.Forward) / Tick, after.Motion!.Acceleration, 1.0);

        Run(game, 5, Nothing);
        EntityState pushed = Entity(game, parked.Handle);
        Assert.True((pushed.Pose.Position - parked.Pose.Position).Length > 0.3, "The parked car did not move.");
        Assert.Equal(Vector3D.Zero, pushed.Velocity);
        Assert.Equal([0, 1, 0], game.Conduct.Collisions);
        Assert.Equal(0, game.Ports.World.ReadEgo().Velocity.Length);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Driver_who_cannot_stop_in_time_crashes_and_the_wreck_stays()
    {
        SimulatedGame game = Game(seed: 4, traffic: 1);
        Vehicle victim = Overtaken(game);
        int handle = victim.Handle;
        List<Impact> impacts = [];
        Run(game, 6, Collect);
        Assert.Contains(impacts, impact => impact.First == handle || impact.Second == handle);
        Assert.NotNull(victim.Wreck);
        Assert.Equal(0, victim.Speed);
        Assert.Equal([1, 0, 0], game.Conduct.Collisions);
        Vector3D place = victim.Pose.Position;
        Run(game, 20, Nothing);
        Assert.Equal(place, victim.Pose.Position);
        VehicleLights?[] lights = new VehicleLights?[2];
        for (int i = 0; i < 60; i++)
        {
            game.Tick(Tick);
            VehicleLights now = Entity(game, handle).Lights!.Value;
            lights[now.Left ? 1 : 0] = now;
        }

        // Both indicators flash together.
        Assert.All(lights, light => Assert.Equal(light!.Value.Left, light.Value.Right));

        void Collect() => impacts.AddRange(game.Impacts);
    }

    [Fact]
    public void Struck_person_is_thrown_and_lies_in_the_way_of_the_car()
    {
        SimulatedGame game = Game(seed: 3, people: 2);
        EntityState person = game
            .Ports.World.ReadEntities(game.Ports.World.ReadEgo().Pose.Position, 300)
            .First(entity => entity.Class == ObjectClass.Pedestrian && entity.Velocity == default);
        Vector3D direction = new(person.Pose.Axes.Forward.X, person.Pose.Axes.Forward.Y, 0);
        game.Ports.Car!.Reset(person.Pose.Position - (direction.Normalized() * 14), Angles.HeadingDegrees(direction));
        _ = game.Conduct;
        (Impact impact, EgoState before) = DriveUntilImpact(game, 8, person.Handle);
        Assert.Equal(person.Handle, impact.Second);
        Assert.Equal(1, game.Conduct.Collisions[(int)EgoContact.Pedestrian]);
        double speed = impact.Impulse.Length / VehicleMass.Person;
        Run(game, 6, Nothing);
        EntityState lying = Entity(game, person.Handle);
        Assert.Equal(Vector3D.Zero, lying.Velocity);
        Assert.True(Math.Abs(lying.Pose.Axes.Up.Z) < 1e-6, "The person does not lie.");

        // Searle: s = v² / (2 μ g) + μ h, where the middle of the body falls by less than half its height, plus the way clear of the car.
        Vector3D half = (person.ModelMax - person.ModelMin) * 0.5;
        Vector3D way =
            lying.Pose.ToWorld((person.ModelMin + person.ModelMax) * 0.5) - person.Pose.ToWorld((person.ModelMin + person.ModelMax) * 0.5);
        double expected = (speed * speed / (2 * 0.66 * 9.81)) + (0.66 * half.Z);
        Assert.InRange(new Vector2D(way.X, way.Y).Length, expected - (0.66 * half.Z), expected + 0.5);
        Assert.True(before.Velocity.Length > 4, $"The car was slow, {before.Velocity.Length} m/s.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Wet_road_lengthens_the_braking_distance_from_the_same_state()
    {
        (double dry, string dryState) = Braked("clear");
        (double wet, string wetState) = Braked("rain");
        Assert.Equal(dryState, wetState);

        // Full brakes: s = v² / (2 (b + r)) with b = 8 m/s² on dry roads. The weather rain has 0.8 of the heaviest rain, which takes 35 %
        // of b. Drag and rolling resistance r, which it does not change, are below 0.3 m/s².
        const double dryBraking = 8;
        const double wetBraking = dryBraking * (1 - (0.35 * 0.8));
        const double maxResistance = 0.3;
        Assert.InRange(wet / dry, (dryBraking + maxResistance) / (wetBraking + maxResistance), dryBraking / wetBraking);

        static (double Metres, string Before) Braked(string weather)
        {
            SimulatedGame game = Game(seed: 5);
            Run(game, 12, Nothing);
            string before = $"{game.World.Ego.Pose} {game.World.Ego.Velocity}";
            Assert.True(game.World.Ego.Speed > 5, $"The ego drives at {game.World.Ego.Speed} m/s.");
            game.Make(new WorldChange(WorldChangeKind.Weather) { Weather = weather });
            game.Make(new WorldChange(WorldChangeKind.Brake) { Value = 8 });
            Vector3D place = game.World.Ego.Pose.Position;
            Run(game, 5, Nothing);
            Assert.Equal(0, game.World.Ego.Speed);
            return ((game.World.Ego.Pose.Position - place).Length, before);
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Crash_repeats_to_the_bit()
    {
        Assert.Equal(States(), States());

        static List<string> States()
        {
            SimulatedGame game = Game(seed: 4, traffic: 1);
            _ = Overtaken(game);
            List<string> states = [];
            for (int i = 0; i < 240; i++)
            {
                game.Tick(Tick);
                states.AddRange(game.World.Vehicles.Select(vehicle => $"{vehicle.Pose} {vehicle.Velocity}"));
            }

            return states;
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Ordinary_traffic_hardly_crashes_and_bodies_never_overlap()
    {
        // At most one impact a minute: two towns for half a minute each, or less.
        double seconds = ProofSize.Of(inCi: 10, full: 30);
        int crashes = 0;
        for (int seed = 21; seed < 23; seed++)
        {
            SimulatedGame game = Game(seed, traffic: 1, people: 1, parked: 1);
            for (int i = 0; i < seconds / Tick; i++)
            {
                game.Tick(Tick);
                crashes += game.Impacts.Count;
                foreach (Vehicle wreck in game.World.Vehicles.Where(vehicle => vehicle.Wreck is not null))
                {
                    Assert.DoesNotContain(
                        game.World.Vehicles,
                        other => other != wreck && wreck.Footprint.Grown(-CrashStep.OverlapTolerance).Overlaps(other.Footprint)
                    );
                }
            }
        }

        Assert.True(crashes <= 1, $"{crashes} impacts in a minute.");
    }

    /// <summary>Puts the ego 2.4 m ahead of the front of a vehicle that drives fast.</summary>
    private static Vehicle Overtaken(SimulatedGame game)
    {
        for (int tick = 0; tick < 60 / Tick; tick++)
        {
            game.Tick(Tick);
            Vehicle? victim = game.World.Vehicles.Skip(1).FirstOrDefault(vehicle => IsFast(game, vehicle));
            if (victim is not null)
            {
                Vector3D place = victim.PoseAhead(victim.FrontOverhang + 4.5).Position;
                _ = game.Conduct;
                game.Ports.Car!.Reset(place, Angles.HeadingDegrees(victim.Pose.Axes.Forward));
                return victim;
            }
        }

        throw new InvalidOperationException("Nobody drives fast in this town.");
    }

    private static bool IsFast(SimulatedGame game, Vehicle vehicle) =>
        vehicle.Speed > 8
        && vehicle.Model.Class == ObjectClass.Car
        && vehicle.Path.Length - vehicle.Distance > 30
        && vehicle.Distance > 10
        && !game.World.Vehicles.Any(other => other != vehicle && (other.Pose.Position - vehicle.PoseAhead(8).Position).Length < 15);

    private static EntityState ParkedCar(SimulatedGame game) =>
        game
            .Ports.World.ReadEntities(game.Ports.World.ReadEgo().Pose.Position, 500)
            .First(entity => entity.Class == ObjectClass.Car && entity.Velocity == default);

    private static EntityState Entity(SimulatedGame game, int handle) =>
        game.Ports.World.ReadEntities(game.Ports.World.ReadEgo().Pose.Position, 1000).Single(entity => entity.Handle == handle);

    private static (Impact Impact, EgoState Before) DriveUntilImpact(SimulatedGame game, double seconds, int? other = null)
    {
        for (int i = 0; i < seconds / Tick; i++)
        {
            EgoState before = game.Ports.World.ReadEgo();
            Assert.Equal(other is null ? [0, 0, 0] : game.Conduct.Collisions, game.Conduct.Collisions);
            game.Ports.Car!.Drive(FullThrottle);
            game.Tick(Tick);
            if (game.Impacts.FirstOrDefault(impact => other is null || impact.Second == other) is { } impact)
            {
                return (impact, before);
            }
        }

        throw new InvalidOperationException("The ego hit nothing.");
    }

    private static void Run(SimulatedGame game, double seconds, Action afterTick)
    {
        for (int i = 0; i < seconds / Tick; i++)
        {
            game.Tick(Tick);
            afterTick();
        }
    }

    private static void Nothing() { }

    private static SimulatedGame Game(int seed, double traffic = 0, double people = 0, double parked = 0) =>
        new(
            new SimulationOptions
            {
                Seed = seed,
                HasCrashes = true,
                TrafficDensity = traffic,
                ParkedDensity = parked,
                PedestrianDensity = people,
            }
        );
}
