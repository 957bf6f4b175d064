using Harvester.Datasets.Validation;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Names of lanes that the session's roads do not have.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class LaneIdCheckTests(SimulatedSession session)
{
    private const string Unknown = "0:99998-0:99999/f0";

    private FrameLabel Good => session.OpenWithRoads().ReadLabels().First(label => label.Lanes?.LaneId is not null);

    [Fact]
    public void Labels_of_a_harvest_name_lanes_of_its_roads()
    {
        FrameLabel[] labels = [.. session.OpenWithRoads().ReadLabels()];
        var check = new LaneIdCheck(session.OpenWithRoads());

        Assert.All(labels, label => Assert.Empty(check.Problems(label)));
        Assert.All(labels, label => Assert.NotNull(label.Lanes!.LaneId));
        Assert.Contains(labels, label => label.Lanes!.LanesAhead!.Count > 1);
        Assert.Contains(labels.SelectMany(label => label.Objects), item => item.LaneId is not null);
        Assert.All(
            labels.SelectMany(label => label.Objects).Where(item => item.LaneId is not null),
            item => Assert.True(VehicleClasses.AreVehicles(item.Class))
        );
    }

    [Fact]
    public void Unknown_lane_of_the_ego_is_found() =>
        AssertProblem(
            Good with
            {
                Lanes = Good.Lanes! with { LaneId = Unknown },
            },
            $"lanes name the lane '{Unknown}', which the session's roads do not have near the car."
        );

    [Fact]
    [Trait("Category", "Heavy")]
    public void Unknown_lane_ahead_is_found() =>
        AssertProblem(
            Good with
            {
                Lanes = Good.Lanes! with { LanesAhead = [Unknown] },
            },
            $"lanes name the lane '{Unknown}', which the session's roads do not have near the car."
        );

    [Fact]
    public void Lanes_ahead_of_no_lane_are_found() =>
        AssertProblem(Good with { Lanes = Good.Lanes! with { LaneId = null } }, "lanes.lanesAhead has lanes, but lanes.laneId is null.");

    [Fact]
    public void Unknown_lane_of_an_object_is_found()
    {
        FrameLabel label = session.OpenWithRoads().ReadLabels().First(label => label.Objects.Count > 0);
        ObjectLabel item = label.Objects[0];

        AssertProblem(
            label with
            {
                Objects = [item with { LaneId = Unknown }],
            },
            $"object {item.Id} names the lane '{Unknown}', which the session's roads do not have near it."
        );
        AssertProblem(
            label with
            {
                Objects = [item with { LaneId = null, GovernedLanes = [Unknown] }],
            },
            $"object {item.Id} names the lane '{Unknown}', which the session's roads do not have near it."
        );
    }

    private void AssertProblem(FrameLabel label, string expected) =>
        Assert.Equal([expected], new LaneIdCheck(session.OpenWithRoads()).Problems(label));
}
