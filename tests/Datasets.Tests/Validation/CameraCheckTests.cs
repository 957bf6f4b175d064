using Harvester.Datasets.Validation;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Cameras that cannot be.</summary>
public sealed class CameraCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_finds_a_camera_of_another_size_than_the_session()
    {
        _session.Info["image"]!["width"] = 800;

        Assert.Contains(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Message.Contains("800 x 60", StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData("verticalFovDegrees", 180, "camera: verticalFovDegrees")]
    [InlineData("nearClip", 0, "camera: nearClip")]
    [InlineData("windowAspect", -1, "camera: windowAspect")]
    [InlineData("fy", 31, "camera: fx and fy are 30 and 31, but the other fields give 30 and 30.")]
    public void Validate_finds_an_impossible_camera(string field, double value, string message)
    {
        _session.Lines[1]["camera"]![field] = value;

        _session.AssertProblem(2, message);
    }
}
