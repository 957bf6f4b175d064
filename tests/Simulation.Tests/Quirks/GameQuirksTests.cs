using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

public sealed class GameQuirksTests
{
    private const double TickSeconds = 0.1;
    private const double MaxDistance = 150;
    private static readonly ImageSize Size = new(64, 48);

    /// <summary>Depth is kept in single precision.</summary>
    private static readonly Vector3D Margin = new(0.002, 0.002, 0.002);

    [Fact]
    public void PictureLagTicks_shows_the_picture_of_that_many_ticks_ago()
    {
        const int lag = 2;
        SimulatedGame prompt = Game(new GameQuirks());
        SimulatedGame late = Game(new GameQuirks { PictureLagTicks = lag });
        List<byte[]> pictures = [];
        for (int tick = 0; tick < 8; tick++)
        {
            prompt.Tick(TickSeconds);
            late.Tick(TickSeconds);
            pictures.Add(Grab(prompt));

            Assert.Equal(tick + 1, prompt.Shown.GameFrame);
            if (tick >= lag)
            {
                Assert.Equal(pictures[tick - lag], Grab(late));
                Assert.Equal(tick + 1 - lag, late.Shown.GameFrame);
                Assert.NotEqual(late.Shown.Ego, late.Ports.World.ReadEgo());
            }
        }

        Assert.NotEqual(pictures[^1], pictures[^2]);
    }

    [Fact]
    public void IsCameraReportedLate_reports_the_camera_of_the_tick_before()
    {
        SimulatedGame game = Game(new GameQuirks { IsCameraReportedLate = true });
        Run(game, 20);
        CameraState before = game.Shown.Camera;
        game.Tick(TickSeconds);

        Assert.Equal(before, game.Ports.World.ReadCamera());
        Assert.NotEqual(before, game.Shown.Camera);

        game.Ports.Pause.Freeze();
        game.Tick(TickSeconds);
        Assert.Equal(game.Shown.Camera, game.Ports.World.ReadCamera());
    }

    [Fact]
    public void VanishingFraction_hides_a_vehicle_after_reading_for_a_while()
    {
        SimulatedGame game = Game(new GameQuirks { VanishingFraction = 1 });
        game.Tick(TickSeconds);
        game.Ports.Pause.Freeze();
        HashSet<int> first = Handles(game);
        HashSet<int> second = Handles(game);

        int gone = Assert.Single(first.Except(second));
        Assert.Empty(second.Except(first));
        Assert.DoesNotContain(gone, game.Shown.Entities.Select(entity => entity.Handle));

        int ticks = 0;
        for (; !game.Shown.Entities.Any(entity => entity.Handle == gone); ticks++)
        {
            Assert.True(ticks < 60, "It does not come back.");
            game.Tick(TickSeconds);
        }

        Assert.True(ticks > 0);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lens_and_aspect_move_pixels_according_to_the_camera_model()
    {
        RenderLens bent = new(1.03, 0.01, -0.02, -0.05, 0.01);
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 6,
                Lens = bent,
                WindowAspect = 1.9,
            }
        );
        Lens same = new(bent.FocalScale, bent.CentreOffsetX, bent.CentreOffsetY, bent.K1, bent.K2);
        int right = 0;
        int all = 0;
        int rightOfPinhole = 0;
        for (int second = 0; second < 8; second++)
        {
            game.Tick(1);
            CameraState state = game.Shown.Camera;
            Camera camera = CameraOf(state, state.WindowAspect, same);
            Camera pinhole = CameraOf(state, Size.Aspect, Lens.Ideal);
            RenderTarget picture = game.Render(Size);
            Dictionary<int, EntityState> entities = game.Shown.Entities.ToDictionary(entity => entity.Handle);
            for (int pixel = 0; pixel < picture.Handles.Length; pixel++)
            {
                if (picture.Handles[pixel] != 0)
                {
                    EntityState entity = entities[picture.Handles[pixel]];
                    Cuboid cuboid = Cuboid.FromModel(entity.ModelMin - Margin, entity.ModelMax + Margin, entity.Pose);
                    all++;
                    right += cuboid.Contains(Unproject(camera, pixel, picture.Depth[pixel])) ? 1 : 0;
                    rightOfPinhole += cuboid.Contains(Unproject(pinhole, pixel, picture.Depth[pixel])) ? 1 : 0;
                }
            }
        }

        Assert.True(all > 200, $"Only {all} pixels of entities.");
        Assert.Equal(all, right);
        Assert.True(rightOfPinhole < all * 0.9, "A pinhole would do.");
    }

    [Fact]
    public void RaysMeetBoxes_stops_rays_at_the_box_around_an_entity()
    {
        Dictionary<int, int> shapes = HitsByHandle(new GameQuirks());
        Dictionary<int, int> boxes = HitsByHandle(new GameQuirks { RaysMeetBoxes = true });

        Assert.True(shapes.Count > 3, "Hardly anything in view.");
        Assert.True(boxes.Values.Sum() > shapes.Values.Sum() * 1.1, "Boxes are hit no more often than shapes.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void RayMissFraction_misses_the_same_far_vehicles_per_seed()
    {
        SimulatedGame whole = Game(new GameQuirks());
        SimulatedGame holed = Game(new GameQuirks { RayMissFraction = 0.5 });
        SimulatedGame again = Game(new GameQuirks { RayMissFraction = 0.5 });
        int missed = 0;
        int met = 0;
        for (int tick = 0; tick < 12; tick++)
        {
            foreach (SimulatedGame game in new[] { whole, holed, again })
            {
                game.Tick(0.5);
            }

            foreach ((Ray ray, RayHit hit) in HitsOf(whole))
            {
                RayHit? other = holed.Ports.Rays.Cast(ray, MaxDistance, 0);
                Assert.Equal(other, again.Ports.Rays.Cast(ray, MaxDistance, 0));
                Vector3D eye = whole.Shown.Camera.Pose.Position;
                EntityState entity = whole.Shown.Entities.Single(entity => entity.Handle == hit.Entity);
                if (entity.Velocity == Vector3D.Zero || entity.Class == ObjectClass.Pedestrian)
                {
                    continue;
                }

                bool isMissed = other?.Entity != hit.Entity;
                Assert.False(isMissed && (entity.Pose.Position - eye).Length < 30, "A near vehicle was missed.");
                missed += isMissed ? 1 : 0;
                met += isMissed || (entity.Pose.Position - eye).Length < 30 ? 0 : 1;
            }
        }

        Assert.True(missed > 5 && met > 5, $"{missed} hits on far vehicles missed, {met} met.");
    }

    private static SimulatedGame Game(GameQuirks quirks) => new(new SimulationOptions { Seed = 6, Quirks = quirks });

    private static void Run(SimulatedGame game, int ticks)
    {
        for (int i = 0; i < ticks; i++)
        {
            game.Tick(TickSeconds);
        }
    }

    private static byte[] Grab(SimulatedGame game)
    {
        PixelBuffer picture = new(Size);
        Assert.True(game.Ports.Screen.Grab(picture).IsGood);
        return picture.Bytes;
    }

    private static HashSet<int> Handles(SimulatedGame game) =>
        [.. game.Ports.World.ReadEntities(game.Shown.Camera.Pose.Position, MaxDistance).Select(entity => entity.Handle)];

    private static Camera CameraOf(CameraState state, double aspect, Lens lens) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Size, aspect, state.NearClip, lens));

    private static Vector3D Unproject(Camera camera, int pixel, double depth) =>
        camera.Unproject((pixel % Size.Width) + 0.5, (pixel / Size.Width) + 0.5, depth);

    private static Dictionary<int, int> HitsByHandle(GameQuirks quirks)
    {
        SimulatedGame game = Game(quirks);
        Run(game, 5);
        return HitsOf(game).GroupBy(pair => pair.Hit.Entity).ToDictionary(group => group.Key, group => group.Count());
    }

    private static IEnumerable<(Ray Ray, RayHit Hit)> HitsOf(SimulatedGame game)
    {
        CameraState state = game.Shown.Camera;
        Camera camera = CameraOf(state, state.WindowAspect, Lens.Ideal);
        for (int pixel = 0; pixel < Size.Width * Size.Height; pixel++)
        {
            Ray ray = camera.RayThrough((pixel % Size.Width) + 0.5, (pixel / Size.Width) + 0.5);
            if (game.Ports.Rays.Cast(ray, MaxDistance, 0) is { Entity: not RayHit.World } hit)
            {
                yield return (ray, hit);
            }
        }
    }
}
