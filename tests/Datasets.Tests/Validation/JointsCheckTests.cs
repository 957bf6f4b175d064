using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Joints that contradict camera, image or box.</summary>
public sealed class JointsCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public JointsCheckTests() => _session.AddJoints();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_accepts_joints_that_fit_the_camera()
    {
        Assert.DoesNotContain(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Message.Contains("joint", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Joints_are_read_as_they_are_written()
    {
        JointsLabel joints = _session.Open().ReadLabels().First().Objects[1].Joints!;

        Assert.Equal(JointVisibility.SelfOccluded, joints[Joint.RightElbow].Visibility);
        Assert.Equal(JointVisibility.Visible, joints[Joint.LeftAnkle].Visibility);
        Assert.Equal(5, joints[Joint.LeftAnkle].Position.Y);
        Assert.Equal(60, joints.Box!.Value.XMin);
    }

    [Theory]
    [InlineData("pixel", "[71, 28]", "its position projects to")]
    [InlineData("pixel", "null", "has no pixel, but is in front of the camera")]
    [InlineData("visibility", "\"outside\"", "its pixel is in the image")]
    [InlineData("pixel", "[90, 30]", "is not in the image, but it is not outside")]
    [InlineData("joint", "\"knee\"", "22 joints in their order")]
    public void Validate_finds_an_impossible_joint(string field, string value, string message)
    {
        _session.Pedestrian(0)["joints"]![2]![field] = JsonNode.Parse(value);

        _session.AssertProblem(1, message);
    }

    [Fact]
    public void Validate_finds_a_joint_outside_its_box()
    {
        _session.Pedestrian(0)["box2dJoints"] = JsonNode.Parse("[60, 25, 95, 40]");

        // The crown is at row 24.3; the middle of the head, at 25.2, is within.
        _session.AssertProblem(1, "joint head_top: its pixel does not lie in box2dJoints");
    }

    [Fact]
    public void Validate_finds_a_missing_joint()
    {
        _session.Pedestrian(0)["joints"]!.AsArray().RemoveAt(Skeleton.Count - 1);

        _session.AssertProblem(1, "22 joints");
    }
}
