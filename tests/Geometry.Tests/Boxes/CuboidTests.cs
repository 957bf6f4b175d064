using FsCheck.Fluent;
using Harvester.Geometry.Boxes;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Boxes;

public sealed class CuboidTests
{
    /// <summary>Step of the walk along a ray that the analytic distances are compared with, metres.</summary>
    private const double WalkStep = 0.005;

    [Fact]
    public void FromModel_lopsided_model_has_its_centre_off_the_origin()
    {
        // Model 2 x 5 x 1.5 m, origin 1 m ahead of the middle and on the ground; at (10, 20, 30) looking west (heading 90):
        // the middle (0, -1, 0.75) lies 1 m to the east.
        Cuboid cuboid = Cuboid.FromModel(new(-1, -3.5, 0), new(1, 1.5, 1.5), new Pose(new(10, 20, 30), Axes.FromHeading(90)));

        Assert.True((cuboid.Centre - new Vector3D(11, 20, 30.75)).Length < 1e-12);
        Assert.Equal(new Vector3D(1, 2.5, 0.75), cuboid.HalfExtents);
    }

    [Fact]
    public void Edges_join_corners_that_differ_in_one_bit()
    {
        Assert.Equal(12, Cuboid.Edges.Distinct().Count());
        Assert.All(Cuboid.Edges, edge => Assert.Equal(1, int.PopCount(edge.Start ^ edge.End)));
    }

    [Fact]
    public void Corner_seven_is_right_front_up()
    {
        var cuboid = new Cuboid(new(10, 0, 0), new(1, 2, 3), Axes.Identity);

        Assert.Equal(new Vector3D(11, 2, 3), cuboid.Corner(7));
        Assert.Equal(new Vector3D(9, -2, -3), cuboid.Corner(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => cuboid.Corner(8));
    }

    [Fact]
    public void Intersect_gives_distances_worked_out_by_hand()
    {
        var cuboid = new Cuboid(new(0, 10, 0), new(1, 2, 3), Axes.Identity);

        Assert.Equal(new RaySpan(8, 12), cuboid.Intersect(new Ray(Vector3D.Zero, new(0, 1, 0))));
        Assert.Equal(new RaySpan(0, 2), cuboid.Intersect(new Ray(new(0, 10, 0), new(0, 1, 0))));
        Assert.Null(cuboid.Intersect(new Ray(Vector3D.Zero, new(0, -1, 0))));
        Assert.Null(cuboid.Intersect(new Ray(new(1.1, 0, 0), new(0, 1, 0))));
        Assert.Equal(new RaySpan(8, 12), cuboid.Intersect(new Ray(new(1, 0, 0), new(0, 1, 0))));
        Assert.Equal(
            new RaySpan(10, 10),
            new Cuboid(new(0, 10, 0), new(1, 0, 1), Axes.Identity).Intersect(new Ray(Vector3D.Zero, new(0, 1, 0)))
        );
    }

    [Fact]
    public void Intersect_agrees_with_a_walk_along_the_ray()
    {
        int hits = 0;
        RandomCases.Check(
            300,
            Arb.Zip(Draws.Cuboids(Draws.Vectors(4)), Arb.Zip(Draws.Vectors(6), Draws.Vectors(3))),
            drawn =>
            {
                (Cuboid cuboid, (Vector3D origin, Vector3D aim)) = drawn;
                var ray = new Ray(origin, cuboid.Centre + aim - origin);
                double? first = null;
                double last = 0;
                for (double t = 0; t < 25; t += WalkStep)
                {
                    if (cuboid.Contains(ray.At(t)))
                    {
                        first ??= t;
                        last = t;
                    }
                }

                RaySpan? span = cuboid.Intersect(ray);

                if (first is { } entry)
                {
                    hits++;
                    Assert.NotNull(span);
                    Assert.Equal(entry, span.Value.Entry, WalkStep);
                    Assert.Equal(last, span.Value.Exit, WalkStep);
                }
                else if (span is { } grazed)
                {
                    Assert.True(grazed.Exit - grazed.Entry < WalkStep, "the walk stepped over a long way through the cuboid");
                }
            }
        );

        Assert.InRange(hits, 50, 250);
    }

    [Fact]
    public void Cuboid_invalid_input_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new Cuboid(new(double.NaN, 0, 0), new(1, 1, 1), Axes.Identity));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Cuboid(Vector3D.Zero, new(1, -1, 1), Axes.Identity));
        Assert.Throws<ArgumentOutOfRangeException>(() =>
            Cuboid.FromModel(new(1, 0, 0), new(0, 1, 1), new Pose(Vector3D.Zero, Axes.Identity))
        );
        Assert.Throws<ArgumentException>(() => new Cuboid(Vector3D.Zero, new(1, 1, 1), default));
    }
}
