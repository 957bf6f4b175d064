using Harvester.Geometry;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Tests.Surveys.Faces;

public sealed class HandMarkingTests
{
    /// <summary>At (10, 20, 3), turned to the west: its right is north, its forward west.</summary>
    private static readonly EntityState Prop = new(
        5,
        ObjectClass.Sign,
        "prop_sign_road_03c",
        new Pose(new Vector3D(10, 20, 3), Axes.FromHeading(90)),
        new Vector3D(-1, -1, 0),
        new Vector3D(1, 1, 3),
        Vector3D.Zero
    );

    [Fact]
    public void ToSpace_has_corners_in_the_model_frame_and_faces_the_viewer()
    {
        var marking = new HandMarking(Prop);
        Vector3D eye = Prop.Pose.ToWorld(new Vector3D(1, -6, 1.5));
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(0.4, -0.1, 1.9)), eye);
        Assert.False(marking.IsComplete);
        Assert.Null(marking.Preview);
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(-0.4, -0.1, 2.7)), eye);

        ModelFace face = marking.ToSpace("ALL TRAFFIC", "", 0);

        // Both marks lie in the plane y = -0.1; two centimetres of depth are added behind it, at greater y.
        AssertClose(new Vector3D(-0.4, -0.08, 2.7), face.FrontUpperLeft);
        AssertClose(new Vector3D(0.4, -0.1, 1.9), face.BackLowerRight);
        Assert.Equal((Facing.Back, Provenance.Measured, "prop_sign_road_03c"), (face.Facing, face.Provenance, face.Model));
        AssertClose(Prop.Pose.ToWorld(new Vector3D(0, -0.09, 2.3)), marking.Preview!.Centre);
    }

    [Theory]
    [InlineData(0, -5, Facing.Back)]
    [InlineData(0, 5, Facing.Front)]
    [InlineData(-5, 0, Facing.Left)]
    [InlineData(5, 0, Facing.Right)]
    public void ToSpace_faces_the_side_that_was_aimed_at(double x, double y, Facing expected)
    {
        var marking = new HandMarking(Prop);
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(-0.3, -0.3, 1)), Prop.Pose.ToWorld(new Vector3D(x, y, 1)));
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(0.3, 0.3, 2)), Prop.Pose.ToWorld(new Vector3D(x, y, 1)));

        Assert.Equal(expected, marking.ToSpace("", "", 0).Facing);
    }

    [Fact]
    public void Marking_a_third_time_starts_over()
    {
        var marking = new HandMarking(Prop);
        Vector3D eye = Prop.Pose.ToWorld(new Vector3D(0, -6, 1.5));
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(-0.4, 0, 1)), eye);
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(0.4, 0, 2)), eye);
        marking.Mark(Prop.Pose.ToWorld(new Vector3D(-0.4, 0, 1)), eye);

        Assert.False(marking.IsComplete);
        Assert.Throws<InvalidOperationException>(() => marking.ToSpace("", "", 0));
    }

    [Fact]
    public void Marking_the_same_point_twice_makes_no_face()
    {
        var marking = new HandMarking(Prop);
        marking.Mark(Prop.Pose.Position, Vector3D.Zero);
        marking.Mark(Prop.Pose.Position, Vector3D.Zero);

        Assert.False(marking.IsComplete);
    }

    private static void AssertClose(Vector3D expected, Vector3D actual) =>
        Assert.True((expected - actual).Length < 1e-9, $"{actual} instead of {expected}");
}
