using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

public sealed class NetworkComparisonTests : IDisposable
{
    private readonly string _file = Path.GetTempFileName();

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void Networks_with_other_nodes_are_matched_by_position()
    {
        // The second has a node in between, is off by half a metre, and holds its links the other way round.
        RoadNetwork first = Network([(0, 0), (0, 100), (100, 100)], [(0, 1, 1, 0), (1, 2, 2, 2)]);
        RoadNetwork second = Network([(0.5, 100), (0.5, 40), (0.5, 0), (100, 100.5)], [(0, 1, 0, 1), (1, 2, 0, 1), (3, 0, 2, 2)]);

        NetworkComparison found = NetworkComparison.Of(first, second);

        Assert.Equal((2, 2, 2), (found.Links, found.Matched, found.SameLanes));
        Assert.Equal((1, 1, 0, 0), (found.OneWayInBoth, found.SameWay, found.OppositeWays, found.OneWayInOne));
    }

    [Fact]
    public void Distant_crossing_or_stacked_links_are_not_matched()
    {
        RoadNetwork first = Network([(0, 0), (0, 100)], [(0, 1, 1, 0)]);

        Assert.Equal(0, NetworkComparison.Of(first, Network([(3, 0), (3, 100)], [(0, 1, 1, 0)])).Matched);
        Assert.Equal(0, NetworkComparison.Of(first, Network([(-50, 50), (50, 50)], [(0, 1, 1, 0)])).Matched);
        Assert.Equal(0, NetworkComparison.Of(first, Network([(0, 0), (0, 100)], [(0, 1, 1, 0)], height: 6)).Matched);
    }

    [Fact]
    public void One_way_links_are_compared_by_travel_direction()
    {
        RoadNetwork first = Network([(0, 0), (0, 100), (0, 200), (0, 300)], [(0, 1, 1, 0), (1, 2, 1, 0), (2, 3, 1, 0)]);
        RoadNetwork second = Network([(0, 0), (0, 100), (0, 200), (0, 300)], [(0, 1, 1, 0), (1, 2, 0, 1), (2, 3, 1, 1)]);

        NetworkComparison found = NetworkComparison.Of(first, second);

        Assert.Equal((3, 2, 1, 1, 1), (found.Matched, found.OneWayInBoth, found.SameWay, found.OppositeWays, found.OneWayInOne));
    }

    [Theory]
    [InlineData("ipl")]
    [InlineData("scene")]
    public void Lanes_in_run_forward_by_default(string form)
    {
        RoadNetwork network = Network([(0, 0), (0, 100)], [(0, 1, 2, 0)]);
        File.WriteAllText(_file, form == "ipl" ? IplText.Of(network) : SceneText.Of(network));

        RoadLink forward = Assert.Single(RoadImporter.Import(_file).Network.Links);
        RoadLink backward = Assert.Single(RoadImporter.Import(_file, LanesIn.Backward).Network.Links);

        Assert.Equal((2, 0), (forward.LanesForward, forward.LanesBackward));
        Assert.Equal((0, 2), (backward.LanesForward, backward.LanesBackward));
        NetworkComparison found = NetworkComparison.Of(network, new RoadNetwork(network.Nodes, [backward]));
        Assert.Equal((1, 0, 1), (found.OneWayInBoth, found.SameWay, found.OppositeWays));
    }

    private static RoadNetwork Network(
        (double X, double Y)[] nodes,
        (int From, int To, int Forward, int Backward)[] links,
        double height = 0
    ) =>
        new(
            [
                .. nodes.Select(
                    (node, i) =>
                        new RoadNode(0, i, new Vector3D(node.X, node.Y, height), string.Empty, RoadNodeFlags.None)
                        {
                            Speed = RoadSpeed.Normal,
                            Density = 5,
                        }
                ),
            ],
            [.. links.Select(link => new RoadLink(link.From, link.To, link.Forward, link.Backward, 0, RoadLinkFlags.None))]
        );
}
