namespace Harvester.Geometry.Tests;

public sealed class ScaledPoseTests
{
    /// <summary>Divisions and products of single steps: a few roundings of numbers up to 10.</summary>
    private const double Rounding = 1e-12;

    private static readonly Vector3D Place = new(10, 20, 30);
    private static readonly Axes Turned = Axes.FromEuler(new EulerAngles(10, 20, 30));

    [Fact]
    public void FromMatrix_rigid_matrix_is_a_pose_without_scale()
    {
        ScaledPose? read = ScaledPose.FromMatrix(Turned.Right, Turned.Forward, Turned.Up, Place);

        Assert.Equal(new ScaledPose(new Pose(Place, Turned), new Vector3D(1, 1, 1)), read);
    }

    [Fact]
    public void FromMatrix_scale_is_split_off_per_axis()
    {
        ScaledPose read = ScaledPose.FromMatrix(Turned.Right * 2, Turned.Forward * 0.5, Turned.Up * 3, Place)!.Value;

        Assert.InRange((read.Scale - new Vector3D(2, 0.5, 3)).Length, 0, Rounding);
        Assert.InRange((read.Pose.Axes.Right - Turned.Right).Length, 0, Rounding);
        Assert.InRange((read.Pose.Axes.Forward - Turned.Forward).Length, 0, Rounding);
        Assert.Equal(Place, read.Pose.Position);

        // A corner of the model goes where the matrix itself puts it.
        var corner = new Vector3D(-1, 2, 0.5);
        Vector3D byMatrix = Place + (Turned.Right * 2 * corner.X) + (Turned.Forward * 0.5 * corner.Y) + (Turned.Up * 3 * corner.Z);
        Assert.InRange((read.Pose.ToWorld(read.Stretch(corner)) - byMatrix).Length, 0, 10 * Rounding);
    }

    [Fact]
    public void FromMatrix_with_single_precision_rounding_has_no_scale() =>
        Assert.Equal(
            new Vector3D(1, 1, 1),
            ScaledPose.FromMatrix(Turned.Right * 1.0005, Turned.Forward * 0.9995, Turned.Up, Place)!.Value.Scale
        );

    [Theory]
    [InlineData(1, 0, 0, 0.2, 1, 0, 0, 0, 1)]
    [InlineData(1, 0, 0, 0, 1, 0, 0.1, 0.1, 1)]
    [InlineData(-1, 0, 0, 0, 1, 0, 0, 0, 1)]
    [InlineData(0, 0, 0, 0, 0, 0, 0, 0, 0)]
    [InlineData(1, 0, 0, 0, 1, 0, 0, 0, 1e-6)]
    [InlineData(double.NaN, 0, 0, 0, 1, 0, 0, 0, 1)]
    [InlineData(double.PositiveInfinity, 0, 0, 0, 1, 0, 0, 0, 1)]
    public void FromMatrix_sheared_mirrored_or_vanishing_is_null(
        double rightX,
        double rightY,
        double rightZ,
        double forwardX,
        double forwardY,
        double forwardZ,
        double upX,
        double upY,
        double upZ
    ) =>
        Assert.Null(
            ScaledPose.FromMatrix(
                new Vector3D(rightX, rightY, rightZ),
                new Vector3D(forwardX, forwardY, forwardZ),
                new Vector3D(upX, upY, upZ),
                Place
            )
        );

    [Fact]
    public void FromMatrix_with_a_position_that_is_not_finite_is_null() =>
        Assert.Null(ScaledPose.FromMatrix(Turned.Right, Turned.Forward, Turned.Up, new Vector3D(double.NaN, 0, 0)));
}
