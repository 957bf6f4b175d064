using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

public sealed class FreezeQuirksTests
{
    private const double TickSeconds = 0.1;

    public static TheoryData<FreezeMethod> Methods => [FreezeMethod.Paused, FreezeMethod.TimeScale];

    [Theory]
    [MemberData(nameof(Methods))]
    public void World_without_quirks_is_completely_frozen(FreezeMethod method)
    {
        SimulatedGame game = Frozen(method, new FreezeQuirks());
        (SceneSnapshot before, byte[] picture) = (Read(game), Grab(game));
        Run(game, 20);

        Assert.Equal(before, Read(game) with { GameFrame = before.GameFrame, Entities = before.Entities });
        Assert.Equal(before.Entities, Read(game).Entities);
        Assert.Equal(picture, Grab(game));
        game.Ports.Pause.Unfreeze();
        game.Tick(TickSeconds);
        Assert.NotEqual(before.Ego, Read(game).Ego);
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void Quirks_of_one_freeze_method_do_not_affect_the_other(FreezeMethod method)
    {
        FreezeMethod other = method == FreezeMethod.Paused ? FreezeMethod.TimeScale : FreezeMethod.Paused;
        SimulatedGame game = Frozen(
            other,
            new FreezeQuirks
            {
                NeverStands = true,
                HoldsCamera = true,
                LetsWeatherGoOn = true,
                ChangesVisibility = true,
            },
            method
        );
        SceneSnapshot before = Read(game);
        game.Ports.MountedCamera!.Shift(new Vector3D(0, 0, 1));
        Run(game, 20);

        Assert.Equal(before.Entities, Read(game).Entities);
        Assert.Equal(before.Environment, Read(game).Environment);
        Assert.Equal(1, HeightAboveCar(game) - HeightAboveCar(before), 9);
    }

    [Theory]
    [InlineData(FreezeMethod.Paused, false)]
    [InlineData(FreezeMethod.Paused, true)]
    [InlineData(FreezeMethod.TimeScale, true)]
    public void HoldsCamera_delays_camera_changes_until_the_game_runs(FreezeMethod method, bool holds)
    {
        SimulatedGame game = Frozen(method, new FreezeQuirks { HoldsCamera = holds });
        (SceneSnapshot before, byte[] picture) = (Read(game), Grab(game));
        game.Ports.MountedCamera!.Shift(new Vector3D(0, 0, 1));
        game.Tick(TickSeconds);

        Assert.Equal(holds, before.Camera == Read(game).Camera);
        Assert.Equal(holds, picture.AsSpan().SequenceEqual(Grab(game)));

        game.Ports.Pause.Unfreeze();
        game.Tick(TickSeconds);
        Assert.Equal(1, HeightAboveCar(game) - HeightAboveCar(before), 9);
        game.Ports.MountedCamera.Shift(Vector3D.Zero);
        game.Tick(TickSeconds);
        Assert.Equal(0, HeightAboveCar(game) - HeightAboveCar(before), 9);
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void CreepTicks_moves_the_world_for_some_ticks_after_a_freeze(FreezeMethod method)
    {
        const int most = 3;
        SimulatedGame game = Game(method, new FreezeQuirks { CreepTicks = most });
        game.Ports.Pause.Method = method;
        HashSet<int> counts = [];
        for (int freeze = 0; freeze < 30; freeze++)
        {
            game.Tick(TickSeconds);
            game.Ports.Pause.Freeze();
            int crept = 0;
            for (int tick = 0; tick < 10; tick++)
            {
                double time = game.Ports.World.TimeSeconds;
                game.Tick(TickSeconds);
                double passed = game.Ports.World.TimeSeconds - time;
                Assert.InRange(passed, 0, TickSeconds / 2);
                Assert.False(passed > 0 && tick >= most, "The world still creeps.");
                crept += passed > 0 ? 1 : 0;
            }

            counts.Add(crept);
            game.Ports.Pause.Unfreeze();
        }

        Assert.Equal([0, 1, 2, 3], counts.Order());
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void NeverStands_moves_the_world_in_every_tick(FreezeMethod method)
    {
        SimulatedGame game = Frozen(method, new FreezeQuirks { NeverStands = true });
        for (int tick = 0; tick < 20; tick++)
        {
            double time = game.Ports.World.TimeSeconds;
            game.Tick(TickSeconds);
            Assert.InRange(game.Ports.World.TimeSeconds - time, 0.001, TickSeconds / 2);
            Assert.False(game.IsFrozen);
        }
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void LetsWeatherGoOn_advances_hour_and_rain_in_a_frozen_world(FreezeMethod method)
    {
        SimulatedGame game = Frozen(method, new FreezeQuirks { LetsWeatherGoOn = true });
        (SceneSnapshot before, byte[] picture) = (Read(game), Grab(game));
        game.Tick(TickSeconds);

        Assert.Equal(before.Entities, Read(game).Entities);
        Assert.Equal(before.Environment.TimeOfDay + TimeSpan.FromMinutes(TickSeconds / 2), Read(game).Environment.TimeOfDay);
        Assert.NotEqual(picture, Grab(game));
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void ChangesVisibility_toggles_a_vehicle_in_a_frozen_world(FreezeMethod method)
    {
        SimulatedGame game = Frozen(method, new FreezeQuirks { ChangesVisibility = true });
        List<int> counts = [];
        for (int tick = 0; tick < 40; tick++)
        {
            counts.Add(Read(game).Entities.Count);
            Assert.Equal(counts[^1], game.Shown.Entities.Count);
            game.Tick(TickSeconds);
        }

        Assert.Equal(1, counts.Max() - counts.Min());
        Assert.True(counts.Zip(counts.Skip(1)).Count(pair => pair.First != pair.Second) >= 3, "No vehicle comes and goes.");
    }

    private static SimulatedGame Game(FreezeMethod quirky, FreezeQuirks quirks) =>
        new(
            new SimulationOptions
            {
                Seed = 4,
                RadiusMetres = 150,
                TrafficDensity = 0.3,
                PedestrianDensity = 0.3,
                Weather = "rain",
                Quirks = quirky == FreezeMethod.Paused ? new GameQuirks { Paused = quirks } : new GameQuirks { TimeScale = quirks },
            }
        );

    /// <summary>
    /// A game that was frozen a tick ago; its quirks are those of one way, it is frozen in that way unless another is named.
    /// </summary>
    private static SimulatedGame Frozen(FreezeMethod quirky, FreezeQuirks quirks, FreezeMethod? by = null)
    {
        SimulatedGame game = Game(quirky, quirks);
        Run(game, 5);
        game.Ports.Pause.Method = by ?? quirky;
        game.Ports.Pause.Freeze();
        game.Tick(TickSeconds);
        return game;
    }

    private static void Run(SimulatedGame game, int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            game.Tick(TickSeconds);
        }
    }

    private static SceneSnapshot Read(SimulatedGame game)
    {
        IWorld world = game.Ports.World;
        CameraState camera = world.ReadCamera();
        return new SceneSnapshot(
            world.GameFrame,
            world.TimeSeconds,
            camera,
            world.ReadEgo(),
            world.ReadEntities(Vector3D.Zero, 1e5),
            world.ReadEnvironment()
        );
    }

    private static double HeightAboveCar(SimulatedGame game) => HeightAboveCar(Read(game));

    private static double HeightAboveCar(SceneSnapshot scene) => scene.Ego.Pose.ToLocal(scene.Camera.Pose.Position).Z;

    private static byte[] Grab(SimulatedGame game)
    {
        PixelBuffer picture = new(new ImageSize(64, 48));
        Assert.True(game.Ports.Screen.Grab(picture).IsGood);
        return picture.Bytes;
    }
}
