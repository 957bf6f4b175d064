using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Boxes;

public sealed class CuboidProjectorTests
{
    private const double Rounding = 1e-9;

    /// <summary>Maximum deviation of the distorted outline from its pieces, pixels.</summary>
    private const double BentEdgePixels = 0.05;

    /// <summary>At the origin, looking north; fx = fy = 300, the image's middle at (400, 300).</summary>
    private static readonly Camera Origin = Looking(Lens.Ideal);

    [Fact]
    public void Project_cuboid_ahead_is_bounded_by_its_near_face()
    {
        // Near face at depth 9, half sizes 1 and 1: 400 ± 300/9, 300 ± 300/9.
        CuboidProjection projection = CuboidProjector.Project(Origin, Cube(0, 10, 0, 1));

        Assert.Equal(BoxOutcome.InImage, projection.Outcome);
        AssertBox(new Box2D(400 - (100 / 3.0), 300 - (100 / 3.0), 400 + (100 / 3.0), 300 + (100 / 3.0)), projection.Box);
        Assert.Equal(projection.Box, projection.AmodalBox);
        Assert.Equal(0, projection.TruncatedFraction);
        Assert.Equal(4, projection.Silhouette.Count);
    }

    [Fact]
    public void Project_half_out_of_the_image_is_half_truncated()
    {
        // A plate at depth 3 in the plane of x: x = -4 ± 1 gives u = 400 - 400 ± 100, half of it left of the image.
        var plate = new Cuboid(new(-4, 3, 0), new(1, 0, 1), Axes.Identity);

        CuboidProjection projection = CuboidProjector.Project(Origin, plate);

        AssertBox(new Box2D(0, 200, 100, 400), projection.Box);
        AssertBox(new Box2D(-100, 200, 100, 400), projection.AmodalBox);
        Assert.Equal(0.5, projection.TruncatedFraction, Rounding);
    }

    [Fact]
    public void Project_across_the_near_plane_is_clipped_and_not_mirrored()
    {
        // A wall 1 m to the right, from 5 m behind to 5 m ahead, without thickness, 1 m up and down: visible from depth 0.1 to 5,
        // at u = 400 + 300/5 = 460 and beyond the right side; mirrored points would reach to the left of the middle.
        var wall = new Cuboid(new(1, 0, 0), new(0, 5, 1), Axes.Identity);

        CuboidProjection projection = CuboidProjector.Project(Origin, wall);

        // At the right side, u = 800, the depth is 0.75 and v = 300 ± 400, cut at the image.
        AssertBox(new Box2D(460, 0, 800, 600), projection.Box);
        AssertBox(new Box2D(460, 300 - 3000, 400 + 3000, 300 + 3000), projection.AmodalBox);
        Assert.InRange(projection.TruncatedFraction, 0.9, 1);
    }

    [Theory]
    [InlineData(0, 2.4e4, 2.5e4)]
    [InlineData(0.01, 1.1e10, 1.2e10)]
    public void Project_beside_the_camera_has_a_finite_amodal_box(double k2, double least, double most)
    {
        // 8 m to the side and 2 m up at the near plane, 0.1 m ahead, is 80 and 20 focal lengths of 300 px; the lens multiplies that by 1 +
        // k2 82.5^4.
        var wall = new Cuboid(new(8, 0, 0), new(0.01, 20, 2), Axes.Identity);

        CuboidProjection projection = CuboidProjector.Project(Looking(new Lens(1, 0, 0, 0, k2)), wall);

        Assert.InRange(projection.AmodalBox!.Value.XMax, least, most);
        Assert.InRange(projection.TruncatedFraction, 0.9, 1);
    }

    [Fact]
    public void Project_around_the_camera_is_the_whole_image()
    {
        foreach (double half in new[] { 0.05, 1, 100 })
        {
            CuboidProjection projection = CuboidProjector.Project(Origin, Cube(0, 0, 0, half));

            Assert.Equal(BoxOutcome.InImage, projection.Outcome);
            Assert.Equal(Origin.Image.Bounds, projection.Box);
        }
    }

    [Fact]
    public void Project_behind_or_beside_is_not_in_the_image()
    {
        CuboidProjection behind = CuboidProjector.Project(Origin, Cube(0, -10, 0, 1));
        Assert.Equal(BoxOutcome.BehindNearPlane, behind.Outcome);
        Assert.Null(behind.Box);
        Assert.Null(behind.AmodalBox);
        Assert.Equal(1, behind.TruncatedFraction);
        Assert.Empty(behind.Silhouette);

        CuboidProjection beside = CuboidProjector.Project(Origin, Cube(-50, 10, 0, 1));
        Assert.Equal(BoxOutcome.OutsideImage, beside.Outcome);
        Assert.Null(beside.Box);
        Assert.Equal(1, beside.TruncatedFraction);
        Assert.NotNull(beside.AmodalBox);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(-0.08, 0.01)]
    [InlineData(0.1, 0)]
    public void Project_silhouette_contains_every_point_of_the_cuboid(double k1, double k2)
    {
        Camera camera = Looking(new Lens(1, 0, 0, k1, k2));
        Arbitrary<Cuboid> cuboids = Cuboids(sideways: 5, nearest: 2, farthest: 30);
        RandomCases.Check(
            300,
            Arb.Zip(cuboids, RandomCases.ArrayOf(Draws.Vectors(1), 30)),
            drawn =>
            {
                (Cuboid cuboid, Vector3D[] places) = drawn;
                CuboidProjection projection = CuboidProjector.Project(camera, cuboid);
                foreach (Vector3D place in places)
                {
                    Vector3D inside =
                        cuboid.Centre
                        + cuboid.Axes.ToWorld(
                            new Vector3D(place.X * cuboid.HalfExtents.X, place.Y * cuboid.HalfExtents.Y, place.Z * cuboid.HalfExtents.Z)
                        );
                    Projection point = camera.Project(inside);
                    if (point.Outcome == ProjectionOutcome.InImage)
                    {
                        Assert.Equal(BoxOutcome.InImage, projection.Outcome);
                        Assert.True(projection.AmodalBox!.Value.Contains(new Box2D(point.U, point.V, point.U, point.V), BentEdgePixels));
                        Assert.True(projection.Box!.Value.Contains(new Box2D(point.U, point.V, point.U, point.V), BentEdgePixels));
                    }
                }
            }
        );
    }

    [Fact]
    public void Project_silhouette_is_where_rays_meet_the_cuboid()
    {
        Arbitrary<Cuboid> cuboids = Cuboids(sideways: 5, nearest: -2, farthest: 20);
        RandomCases.Check(
            200,
            Arb.Zip(cuboids, RandomCases.ArrayOf(Draws.Pixels(800, 600), 50)),
            drawn =>
            {
                (Cuboid cuboid, Vector2D[] pixels) = drawn;
                CuboidProjection projection = CuboidProjector.Project(Origin, cuboid);
                foreach (Vector2D pixel in pixels)
                {
                    // The ray counts from the near plane on, as the projection does; from inside the cuboid everything is covered.
                    bool met = IsMet(Origin, cuboid, pixel.X, pixel.Y);

                    Assert.Equal(met || cuboid.Contains(Vector3D.Zero), ConvexPolygon.Contains(projection.Silhouette, pixel));
                }
            }
        );
    }

    [Theory]
    [InlineData(-0.08, 0.01, true)]
    [InlineData(-0.08, 0.01, false)]
    [InlineData(0.1, 0, true)]
    [InlineData(0.1, 0, false)]
    public void Project_with_distortion_bounds_rays_across_the_near_plane(double k1, double k2, bool isAcrossNearPlane)
    {
        const double inside = 0.5;
        const double step = 0.2;
        Camera camera = Looking(new Lens(1, 0, 0, k1, k2));
        Arbitrary<Cuboid> cuboids = Cuboids(sideways: 6, nearest: -3, farthest: isAcrossNearPlane ? 5 : 20, height: 2);
        Arbitrary<Cuboid> seen = cuboids.Filter(cuboid =>
            !cuboid.Contains(Vector3D.Zero)
            && IsAcrossNearPlane(camera, cuboid) == isAcrossNearPlane
            && CuboidProjector.Project(camera, cuboid).Box is not null
        );
        RandomCases.Check(
            25,
            seen,
            cuboid =>
            {
                Box2D box = CuboidProjector.Project(camera, cuboid).Box!.Value;
                for (double u = 2; u < 800; u += 20)
                {
                    for (double v = 2; v < 600; v += 20)
                    {
                        Assert.True(
                            !IsMet(camera, cuboid, u, v) || box.Contains(new Box2D(u, v, u, v), BentEdgePixels),
                            $"{cuboid} is outside of {box}"
                        );
                    }
                }

                if (box.Width > 1 && box.Height > 1)
                {
                    Assert.True(IsMetBetween(box.XMin + inside, box.YMin, box.XMin + inside, box.YMax), $"left of {box} of {cuboid}");
                    Assert.True(IsMetBetween(box.XMax - inside, box.YMin, box.XMax - inside, box.YMax), $"right of {box} of {cuboid}");
                    Assert.True(IsMetBetween(box.XMin, box.YMin + inside, box.XMax, box.YMin + inside), $"top of {box} of {cuboid}");
                    Assert.True(IsMetBetween(box.XMin, box.YMax - inside, box.XMax, box.YMax - inside), $"bottom of {box} of {cuboid}");
                }

                bool IsMetBetween(double u, double v, double toU, double toV)
                {
                    int steps = (int)((toU - u + toV - v) / step);
                    return Enumerable
                        .Range(0, steps + 1)
                        .Any(i => IsMet(camera, cuboid, u + ((toU - u) * i / steps), v + ((toV - v) * i / steps)));
                }
            }
        );
    }

    private static bool IsAcrossNearPlane(Camera camera, Cuboid cuboid) =>
        cuboid.EdgesInWorld.Any(edge => (edge.Start.Y < camera.Intrinsics.NearClip) != (edge.End.Y < camera.Intrinsics.NearClip));

    private static bool IsMet(Camera camera, Cuboid cuboid, double u, double v)
    {
        Ray ray = camera.RayThrough(u, v);
        return cuboid.Intersect(ray) is { } span && span.Exit >= camera.Intrinsics.NearClip / ray.Direction.Y;
    }

    private static Arbitrary<Cuboid> Cuboids(double sideways, double nearest, double farthest, double? height = null) =>
        Draws.Cuboids(
            Arb.Convert(
                Arb.Zip(
                    RandomCases.Number(-sideways, sideways),
                    Arb.Zip(RandomCases.Number(nearest, farthest), RandomCases.Number(-(height ?? sideways), height ?? sideways))
                ),
                drawn => new Vector3D(drawn.Item1, drawn.Item2.Item1, drawn.Item2.Item2),
                centre => (centre.X, (centre.Y, centre.Z))
            )
        );

    private static Camera Looking(Lens lens) =>
        new(new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.1, lens));

    private static Cuboid Cube(double x, double y, double z, double half) => new(new(x, y, z), new(half, half, half), Axes.Identity);

    private static void AssertBox(Box2D expected, Box2D? actual)
    {
        Assert.NotNull(actual);
        Assert.True(
            expected.Contains(actual.Value, Rounding) && actual.Value.Contains(expected, Rounding),
            $"expected {expected}, got {actual}"
        );
    }
}
