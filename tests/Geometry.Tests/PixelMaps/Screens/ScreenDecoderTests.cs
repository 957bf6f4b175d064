using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.PixelMaps.Screens;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Tests.PixelMaps.Screens;

public sealed class ScreenDecoderTests
{
    /// <summary>The floor of a screen hides half a centimetre of a ball, less than a row of pixels; the rest is noise.</summary>
    private const double MinIou = 0.97;

    private static readonly Camera Camera = new(
        new Pose(new Vector3D(0, 0, 1.5), Axes.Identity),
        new CameraIntrinsics(50, new ImageSize(320, 240), 4.0 / 3, 0.15, Lens.Ideal)
    );

    /// <summary>A grey ball like the ground, one behind it, and one alone in the shade of its own.</summary>
    private static readonly (Vector3D Centre, double Radius, Vector3D Colour)[] Balls =
    [
        (new Vector3D(0, 9, 0.8), 0.8, new Vector3D(105, 105, 105)),
        (new Vector3D(0.9, 12, 1), 1, new Vector3D(160, 40, 30)),
        (new Vector3D(-3, 11, 0.5), 0.5, new Vector3D(45, 45, 50)),
    ];

    private static readonly Vector3D Post = new(-0.3, 7, 0);

    [Fact]
    public void Objects_are_found_with_their_hidden_parts()
    {
        (CodedMask mask, BallWorld world) = Decoded();
        for (int ball = 0; ball < Balls.Length; ball++)
        {
            int own = ball;
            ushort number = (ushort)(ball + 1);
            Assert.InRange(Iou(pixel => mask.Map.Ids[pixel] == number, pixel => world.BallAt(pixel, _ => true) == own), MinIou, 1);
            Assert.InRange(
                Iou(
                    pixel => mask.Amodal[number][pixel % Camera.Image.Width, pixel / Camera.Image.Width],
                    pixel => world.BallAt(pixel, index => index == own) == own
                ),
                MinIou,
                1
            );
        }
    }

    [Fact]
    public void Pictures_must_match_the_plan()
    {
        ScreenPlan plan = ScreenPlan.For(Camera, Targets());

        Assert.Throws<ArgumentException>(() => plan.Decoder([new byte[3 * Camera.Image.PixelCount]]));
    }

    private static (CodedMask Mask, BallWorld World) Decoded()
    {
        var world = new BallWorld(Camera, Balls, Post);
        ScreenPlan plan = ScreenPlan.For(Camera, Targets());
        IMaskDecoder decoder = plan.Decoder([.. Enumerable.Range(0, plan.PictureCount).Select(number => world.Picture(plan, number))]);
        WorkRun.Complete(decoder.Decode());
        return (decoder.Mask!, world);
    }

    private static MapTarget[] Targets() =>
        [
            .. Balls.Select(
                (ball, index) =>
                {
                    var cuboid = new Cuboid(ball.Centre, new Vector3D(ball.Radius, ball.Radius, ball.Radius), Axes.Identity);
                    return new MapTarget(index + 100, (ushort)(index + 1), cuboid, CuboidProjector.Project(Camera, cuboid));
                }
            ),
        ];

    private static double Iou(Func<int, bool> found, Func<int, bool> expected)
    {
        (int shared, int any) = (0, 0);
        for (int pixel = 0; pixel < Camera.Image.PixelCount; pixel++)
        {
            (bool isFound, bool isExpected) = (found(pixel), expected(pixel));
            shared += isFound && isExpected ? 1 : 0;
            any += isFound || isExpected ? 1 : 0;
        }

        return (double)shared / Math.Max(1, any);
    }
}
