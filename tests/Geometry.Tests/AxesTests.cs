using FsCheck.Fluent;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests;

public sealed class AxesTests
{
    /// <summary>Products of sines and cosines: a few roundings of numbers up to 1.</summary>
    private const double Rounding = 1e-12;

    /// <summary>Near pitch 90 the angles are badly conditioned; the directions they stand for are compared instead, this closely.</summary>
    private const double AfterInverse = 1e-9;

    public static TheoryData<string> EulerCases => [.. Vectors.Read("euler.csv").Select(row => row["case"])];

    [Theory]
    [MemberData(nameof(EulerCases))]
    public void FromEuler_golden_vectors_give_the_axes(string name)
    {
        IReadOnlyDictionary<string, string> row = Vectors.Read("euler.csv").Single(r => r["case"] == name);

        Axes axes = Axes.FromEuler(new EulerAngles(row.Number("pitchDegrees"), row.Number("rollDegrees"), row.Number("yawDegrees")));

        AssertClose(row.Vector("right"), axes.Right, row.Number("tolerance"));
        AssertClose(row.Vector("forward"), axes.Forward, row.Number("tolerance"));
        AssertClose(row.Vector("up"), axes.Up, row.Number("tolerance"));
    }

    [Fact]
    public void ToEuler_random_orientations_invert_FromEuler() =>
        RandomCases.Check(
            2_000,
            Draws.Orientations(89),
            angles =>
            {
                EulerAngles back = Axes.FromEuler(angles).ToEuler();

                Assert.Equal(angles.PitchDegrees, back.PitchDegrees, AfterInverse);
                Assert.Equal(angles.RollDegrees, back.RollDegrees, AfterInverse);
                Assert.Equal(angles.YawDegrees, back.YawDegrees, AfterInverse);
            }
        );

    [Theory]
    [InlineData(90)]
    [InlineData(-90)]
    public void ToEuler_straight_up_or_down_gives_angles_of_the_same_axes(double pitch)
    {
        Axes axes = Axes.FromEuler(new EulerAngles(pitch, 20, 50));

        EulerAngles back = axes.ToEuler();

        // Looking up, roll and yaw add (70); looking down they subtract (30).
        Assert.Equal(0, back.RollDegrees);
        Assert.Equal(pitch > 0 ? 70 : 30, back.YawDegrees, 1e-6);
        AssertClose(axes.Right, Axes.FromEuler(back).Right, AfterInverse);
        AssertClose(axes.Up, Axes.FromEuler(back).Up, AfterInverse);
    }

    [Fact]
    public void ToEuler_exactly_south_and_upside_down_is_plus_180()
    {
        // The range is (-180, 180]; the arctangent of minus zero would give -180.
        Axes south = Axes.FromVectors(new(-1, 0, 0), new(0, -1, 0), new(0, 0, 1));
        Axes upsideDown = Axes.FromVectors(new(-1, 0, 0), new(0, 1, 0), new(0, 0, -1));

        Assert.Equal(180, south.ToEuler().YawDegrees);
        Assert.Equal(180, upsideDown.ToEuler().RollDegrees);
        Assert.False(double.IsNegative(Axes.Identity.ToEuler().YawDegrees));
    }

    [Fact]
    public void FromVectors_single_precision_axes_become_exactly_orthonormal() =>
        RandomCases.Check(
            500,
            Draws.Orientations(90),
            angles =>
            {
                Axes exact = Axes.FromEuler(angles);

                Axes axes = Axes.FromVectors(Single(exact.Right), Single(exact.Forward), Single(exact.Up));

                Assert.Equal(1, axes.Right.Length, Rounding);
                Assert.Equal(0, axes.Right.Dot(axes.Forward), Rounding);
                AssertClose(axes.Up, axes.Right.Cross(axes.Forward), Rounding);
                AssertClose(exact.Forward, axes.Forward, 1e-6);
            }
        );

    [Fact]
    public void FromVectors_refuses_left_handed_long_or_skewed_axes()
    {
        Assert.Throws<ArgumentException>(() => Axes.FromVectors(new(-1, 0, 0), new(0, 1, 0), new(0, 0, 1)));
        Assert.Throws<ArgumentException>(() => Axes.FromVectors(new(2, 0, 0), new(0, 1, 0), new(0, 0, 1)));
        Assert.Throws<ArgumentException>(() => Axes.FromVectors(new(0.8, 0.6, 0), new(0, 1, 0), new(0, 0, 1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => Axes.FromVectors(new(double.NaN, 0, 0), new(0, 1, 0), new(0, 0, 1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => Axes.FromEuler(new EulerAngles(0, double.PositiveInfinity, 0)));
    }

    [Fact]
    public void ToLocal_of_ToWorld_is_the_vector() =>
        RandomCases.Check(
            500,
            Arb.Zip(Draws.Orientations(90), Draws.Vectors(100)),
            drawn =>
            {
                (EulerAngles angles, Vector3D vector) = drawn;
                Axes axes = Axes.FromEuler(angles);

                AssertClose(vector, axes.ToLocal(axes.ToWorld(vector)), 1e-11);
            }
        );

    [Fact]
    public void Compose_camera_ahead_of_a_car_that_looks_west()
    {
        // A car at (10, 20, 0) with heading 90 looks west; 2 m ahead and 0.4 m up is (8, 20, 0.4).
        var car = new Pose(new(10, 20, 0), Axes.FromHeading(90));

        Pose camera = car.Compose(new Pose(new(0, 2, 0.4), Axes.Identity));

        AssertClose(new(8, 20, 0.4), camera.Position, Rounding);
        AssertClose(new(-1, 0, 0), camera.Axes.Forward, Rounding);
        AssertClose(new(0, 2, 0.4), car.ToLocal(camera.Position), Rounding);
    }

    private static Vector3D Single(Vector3D v) => new((float)v.X, (float)v.Y, (float)v.Z);

    private static void AssertClose(Vector3D expected, Vector3D actual, double tolerance) =>
        Assert.True((expected - actual).Length <= tolerance * Math.Sqrt(3), $"expected {expected}, got {actual}");

    [Fact]
    public void FromVectors_preserves_axes_made_by_a_factory_exactly()
    {
        Axes axes = Axes.FromEuler(new EulerAngles(-7.3, 11.9, 143.2));

        Assert.Equal(axes, Axes.FromVectors(axes.Right, axes.Forward, axes.Up));
    }
}
