using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.PixelMaps.Screens;

namespace Harvester.Geometry.Tests.PixelMaps.Screens;

public sealed class ScreenPlanTests
{
    private const int MaxPictures = 17;

    /// <summary>
    /// A screen is 5 cm from the cuboid, and its floor half a centimetre above it; along a flat line of sight that is so much, metres.
    /// </summary>
    private const double FloorTolerance = 0.5;

    private static readonly Camera Camera = new(
        new Pose(new Vector3D(0, 0, 1.5), Axes.Identity),
        new CameraIntrinsics(50, new ImageSize(320, 240), 4.0 / 3, 0.15, Lens.Ideal)
    );

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(20)]
    [InlineData(127)]
    public void A_plan_has_at_most_seventeen_pictures(int objects) =>
        Assert.InRange(ScreenPlan.For(Camera, Row(objects)).PictureCount, 2, MaxPictures);

    [Fact]
    public void Objects_apart_share_their_pictures()
    {
        MapTarget[] targets = [.. Enumerable.Range(0, 5).Select(number => Target(number, new Vector3D((4 * number) - 8, 30, 0.75)))];

        // All and none, and each object once before its screen and once hidden.
        Assert.Equal(4, ScreenPlan.For(Camera, targets).PictureCount);
    }

    [Theory]
    [InlineData(20)]
    [InlineData(127)]
    public void Each_object_is_shown_once_before_a_screen(int objects)
    {
        MapTarget[] targets = Row(objects);
        ScreenPlan plan = ScreenPlan.For(Camera, targets);
        for (int target = 0; target < objects; target++)
        {
            Assert.True(plan.IsShown(0, target));
            Assert.False(plan.IsShown(1, target));
            int[] shown = [.. Enumerable.Range(2, plan.PictureCount - 2).Where(picture => plan.IsShown(picture, target))];
            Assert.Single(shown);
            Assert.Contains(target, plan.ScreensOf(shown[0]));
        }

        Assert.Empty(plan.Sheets(0));
        Assert.Empty(plan.Sheets(1));
    }

    [Fact]
    public void A_screen_covers_the_silhouette_behind_the_object()
    {
        MapTarget target = Target(0, new Vector3D(3, 12, 0.75));
        ScreenPlan plan = ScreenPlan.For(Camera, [target]);
        IReadOnlyList<ScreenSheet> sheets = plan.Sheets(2);
        Box2D box = target.Projection.Box!.Value;
        for (int row = (int)box.YMin; row < box.YMax; row++)
        {
            for (int column = (int)box.XMin; column < box.XMax; column++)
            {
                Ray ray = Camera.RayThrough(column + 0.5, row + 0.5);
                if (target.Cuboid.Intersect(ray) is { } span)
                {
                    double met = sheets.Min(sheet => DistanceTo(sheet, ray));
                    Assert.InRange(met, span.Exit - FloorTolerance, span.Exit + FloorTolerance);
                }
            }
        }
    }

    /// <summary>The distance to a parallelogram, from its plane and its two sides.</summary>
    private static double DistanceTo(ScreenSheet sheet, Ray ray)
    {
        (Vector3D along, Vector3D across) = (sheet.B - sheet.A, sheet.D - sheet.A);
        Vector3D normal = along.Cross(across);
        double distance = (sheet.A - ray.Origin).Dot(normal) / ray.Direction.Dot(normal);
        Vector3D place = ray.Origin + (ray.Direction * distance) - sheet.A;
        double u = place.Dot(along) / along.Dot(along);
        double v = place.Dot(across) / across.Dot(across);
        return distance > 0 && u is >= 0 and <= 1 && v is >= 0 and <= 1 ? distance : double.PositiveInfinity;
    }

    /// <summary>Objects one behind another, so that their screens overlap.</summary>
    private static MapTarget[] Row(int count) =>
        [.. Enumerable.Range(0, count).Select(number => Target(number, new Vector3D((number % 9) - 4, 20 + number, 0.75)))];

    private static MapTarget Target(int number, Vector3D centre)
    {
        var cuboid = new Cuboid(centre, new Vector3D(0.9, 2, 0.75), Axes.Identity);
        return new MapTarget(number + 100, (ushort)(number + 1), cuboid, CuboidProjector.Project(Camera, cuboid));
    }
}
