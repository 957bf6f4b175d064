using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests;

public class SimulatedGameTests
{
    private const double EverythingMetres = 5000;

    /// <summary>Depth is kept in single precision: 4e-6 m at 60 m, and more on faces seen at a grazing angle.</summary>
    private static readonly Vector3D SinglePrecision = new(0.002, 0.002, 0.002);

    [Fact]
    public void Tick_same_seed_gives_same_states_and_same_picture()
    {
        (string states, byte[] picture) = Play(seed: 4);
        (string again, byte[] pictureAgain) = Play(seed: 4);
        (string other, byte[] otherPicture) = Play(seed: 5);

        Assert.Equal(states, again);
        Assert.Equal(picture, pictureAgain);
        Assert.NotEqual(states, other);
        Assert.NotEqual(picture, otherPicture);
    }

    [Fact]
    public void Tick_frozen_counts_frames_but_moves_nothing()
    {
        SimulatedGame game = new(new SimulationOptions());
        IWorld world = game.Ports.World;
        game.Tick(0.1);
        string before = States(world);
        game.Ports.Pause.Freeze();
        game.Tick(0.1);
        game.Tick(0.1);

        Assert.Equal(3, world.GameFrame);
        Assert.Equal(0.1, world.TimeSeconds, 12);
        Assert.Equal(before, States(world));

        game.Ports.Pause.Unfreeze();
        game.Tick(0.1);
        Assert.NotEqual(before, States(world));
    }

    [Fact]
    public void ReadEnvironment_time_runs_thirty_times_as_fast()
    {
        SimulatedGame game = new(new SimulationOptions { TrafficDensity = 0, TimeOfDay = new TimeSpan(23, 59, 30) });
        for (int i = 0; i < 20; i++)
        {
            game.Tick(0.1);
        }

        // 2 s of play are a minute of the game's day, past midnight here.
        Assert.Equal(30, game.Ports.World.ReadEnvironment().TimeOfDay.TotalSeconds, 3);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Ego_drives_within_its_lane_outside_junctions()
    {
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 2,
                TrafficDensity = 0.2,
                PedestrianDensity = 0,
            }
        );
        int judged = 0;
        double driven = 0;
        for (int i = 0; i < 1200; i++)
        {
            game.Tick(0.1);
            EgoState ego = game.Ports.World.ReadEgo();
            driven += ego.Velocity.Length * 0.1;
            LanePosition? position = game.Truth.Locate(ego.Pose.Position, ego.Pose.Axes.Forward);
            if (position is { IsInJunction: false })
            {
                judged++;
                Assert.NotNull(position.Lane);

                // Lanes are driven as polylines of 0.5 m: in a bend of 6 m radius the chord is 0.5²/(8·6) = 5 mm off.
                Assert.InRange(position.RightOfLaneCentre, -0.02, 0.02);
                Assert.InRange(position.AngleToRoad, -0.05, 0.05);
            }
        }

        Assert.True(judged > 300, $"Only {judged} frames outside junctions.");
        Assert.True(driven > 300, $"Only {driven:F0} m driven in two minutes.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Render_every_pixel_of_an_entity_lies_in_its_cuboid()
    {
        SimulatedGame game = new(new SimulationOptions { Seed = 3 });
        ImageSize size = new(320, 240);
        HashSet<ObjectClass> seen = [];
        for (int i = 0; i < 15; i++)
        {
            game.Tick(1);
            RenderTarget picture = game.Render(size);
            CameraState camera = game.Ports.World.ReadCamera();
            Dictionary<int, EntityState> entities = game
                .Ports.World.ReadEntities(camera.Pose.Position, EverythingMetres)
                .ToDictionary(entity => entity.Handle);
            double halfHeight = Math.Tan(camera.VerticalFovDegrees * Math.PI / 360);
            for (int pixel = 0; pixel < picture.Handles.Length; pixel++)
            {
                if (picture.Handles[pixel] != 0)
                {
                    double right = ((2 * ((pixel % size.Width) + 0.5) / size.Width) - 1) * halfHeight * camera.WindowAspect;
                    double up = (1 - (2 * ((pixel / size.Width) + 0.5) / size.Height)) * halfHeight;
                    Vector3D place = camera.Pose.ToWorld(new Vector3D(right, 1, up) * picture.Depth[pixel]);
                    EntityState entity = entities[picture.Handles[pixel]];
                    Cuboid cuboid = Cuboid.FromModel(entity.ModelMin - SinglePrecision, entity.ModelMax + SinglePrecision, entity.Pose);
                    Assert.True(cuboid.Contains(place), $"{entity.Model} is drawn outside of its cuboid at {place}.");
                    seen.Add(entity.Class);
                }
            }
        }

        Assert.Contains(ObjectClass.Car, seen);
        Assert.Contains(ObjectClass.Pedestrian, seen);
        Assert.Contains(ObjectClass.Sign, seen);
        Assert.Contains(ObjectClass.TrafficLight, seen);
    }

    private static (string States, byte[] Picture) Play(int seed)
    {
        SimulatedGame game = new(new SimulationOptions { Seed = seed });
        for (int i = 0; i < 30; i++)
        {
            game.Tick(0.1);
        }

        PixelBuffer picture = new(new ImageSize(160, 120));
        Assert.True(game.Ports.Screen.Grab(picture).IsGood);
        return (States(game.Ports.World), picture.Bytes);
    }

    private static string States(IWorld world)
    {
        EgoState ego = world.ReadEgo();
        return string.Join(
            '\n',
            world.ReadEntities(ego.Pose.Position, EverythingMetres).Select(entity => entity.ToString()).Prepend(ego.ToString())
        );
    }
}
