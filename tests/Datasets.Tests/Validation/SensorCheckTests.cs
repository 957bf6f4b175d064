using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>What is read and refused of the samples of an inertial unit and the detections of a radar.</summary>
public sealed class SensorCheckTests : IDisposable
{
    private const string Imu = """{"timesSeconds":[0.1,0.2],"angularRates":[1,2,3,4,5,6],"specificForces":[7,8,9,10,11,12]}""";

    private const string Radar = """
        [{"sensor":"ahead","raysCast":9,"ranges":[5,9],"azimuthsDegrees":[1,2],"elevationsDegrees":[0,1],"radialVelocities":[-3,4],
        "groundVelocities":[0,5],"crossSections":[10,-2],"objects":[2,0],"origins":[0,2]}]
        """;

    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Samples_and_detections_are_read_back()
    {
        _session.Lines[0]["imu"] = JsonNode.Parse(Imu);
        _session.Lines[0]["radar"] = JsonNode.Parse(Radar);
        FrameLabel label = _session.Open().ReadLabels().First();

        Assert.Equal(
            [
                new ImuSample(0.1, new Vector3D(1, 2, 3), new Vector3D(7, 8, 9)),
                new ImuSample(0.2, new Vector3D(4, 5, 6), new Vector3D(10, 11, 12)),
            ],
            label.Channels.Get<ImuLabel>()!.Samples
        );
        Assert.Equal(
            [new RadarDetection(5, 1, 0, -3, 0, 10, 2, RadarOrigin.Target), new RadarDetection(9, 2, 1, 4, 5, -2, 0, RadarOrigin.Clutter)],
            Assert.Single(label.Channels.Get<RadarsLabel>()!.Scans).Detections
        );
        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Theory]
    [InlineData("[0.1,0.2]", "[0.2,0.2]", "sample 0 of imu is not before what follows it.")]
    [InlineData("[0.1,0.2]", "[0.1,1.2]", "sample 1 of imu is not before what follows it.")]
    [InlineData("[1,2,3,4,5,6]", "[1,2,3,4,5,600]", "sample 1 of imu is more than a vehicle can do.")]
    [InlineData("[1,2,3,4,5,6]", "[1,2,3,4,5]", "imu has 2 times, 5 numbers of rates and 6 of forces")]
    public void Impossible_sample_is_a_problem(string old, string damaged, string message)
    {
        _session.Lines[0]["imu"] = JsonNode.Parse(Imu.Replace(old, damaged, StringComparison.Ordinal));

        _session.AssertProblem(1, message);
    }

    [Theory]
    [InlineData(
        "\"ranges\":[5,9]",
        "\"ranges\":[9,5]",
        "detection 1 of radar 'ahead' is not beyond the sensor and the detection before it."
    )]
    [InlineData("\"ranges\":[5,9]", "\"ranges\":[0,9]", "detection 0 of radar 'ahead' is not beyond the sensor")]
    [InlineData(
        "\"elevationsDegrees\":[0,1]",
        "\"elevationsDegrees\":[0,91]",
        "detection 1 of radar 'ahead' has an angle outside its range."
    )]
    [InlineData("\"objects\":[2,0]", "\"objects\":[2,2]", "detection 1 of radar 'ahead' is clutter and has an object.")]
    [InlineData("\"objects\":[2,0]", "\"objects\":[2,0.5]", "objects of radar must be ids of objects, or 0.")]
    [InlineData("\"origins\":[0,2]", "\"origins\":[0,3]", "origins of radar must be 0, 1 or 2.")]
    [InlineData("\"crossSections\":[10,-2]", "\"crossSections\":[10]", "crossSections of radar must have a number for each of its ranges.")]
    public void Impossible_detection_is_a_problem(string old, string damaged, string message)
    {
        _session.Lines[0]["radar"] = JsonNode.Parse(Radar.Replace(old, damaged, StringComparison.Ordinal));

        _session.AssertProblem(1, message);
    }
}
