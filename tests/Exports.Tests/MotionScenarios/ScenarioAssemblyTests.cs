using Harvester.Datasets.Logs;
using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.MotionScenarios;

/// <summary>Scenarios made of what frames give.</summary>
public sealed class ScenarioAssemblyTests
{
    [Fact]
    public void Light_is_that_of_frames_and_unknown_where_two_disagree()
    {
        MotionLog log = Assemble(Moment(0, LogLight.Stop), Moment(0.2, LogLight.Stop), Moment(0.4, LogLight.Go), Moment(0.5, LogLight.Go));

        Assert.Equal(
            [LogLight.Stop, LogLight.Stop, LogLight.Stop, LogLight.Unknown, LogLight.Go, LogLight.Go],
            log.Signals.Select(step => step.Single().Light)
        );
        Assert.All(log.Signals, step => Assert.Equal(new Vector3D(10, 0, 0), step.Single().Stop));
    }

    [Fact]
    public void Steps_between_frames_far_apart_are_missing()
    {
        MotionLog log = Assemble(Moment(0, LogLight.Stop), Moment(1, LogLight.Stop), Moment(1.1, LogLight.Stop));

        Assert.Equal(
            [true, false, false, false, false, false, false, false, false, false, true, true],
            log.Tracks[log.Ego].States.Select(state => state is not null)
        );
    }

    [Fact]
    public void Heading_turns_over_the_smaller_angle()
    {
        MotionMoment before = Moment(0, LogLight.Stop, heading: 3.1);
        MotionMoment after = Moment(0.2, LogLight.Stop, heading: -3.1);
        MotionLog log = Assemble(before, after);

        const double decimals = 1e-6;
        Assert.Equal(Math.PI, Math.Abs(log.Tracks[log.Ego].States[1]!.Value.Heading), decimals);
    }

    private static MotionMoment Moment(double seconds, LogLight light, double heading = 0) =>
        new(
            seconds,
            [
                new MotionActor(
                    MotionActors.Ego,
                    null,
                    TrafficLogKind.Vehicle,
                    new LogState(new Vector3D(seconds, 0, 0), 4, 2, 1, heading, new Vector2D(1, 0))
                ),
            ],
            new Dictionary<string, LogLight> { ["lane"] = light },
            [new NamedFeature("lane", LogFeatureKind.Lane, 2, [new Vector3D(0, 0, 0), new Vector3D(10, 0, 0)])]
        );

    private static MotionLog Assemble(params MotionMoment[] moments) =>
        ScenarioAssembly
            .Of(
                ScenarioWindow.Name(0, 0),
                moments.Select(moment =>
                {
                    using var stream = new MemoryStream();
                    MotionPart.Write(stream, moment);
                    return stream.ToArray();
                })
            )
            .Log;
}
