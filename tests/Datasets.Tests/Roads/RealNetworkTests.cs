using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>The import of the whole game's network, against counts that were taken from the dump by other means.</summary>
[Trait("Category", "Heavy")]
public sealed class RealNetworkTests(ITestOutputHelper output)
{
    [RealWorldFact("nodes.zip")]
    public void Import_dump_of_the_whole_game_has_every_node_link_and_lane()
    {
        RoadImport import = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!);

        Assert.Equal(67_454, import.Network.Nodes.Count);
        Assert.Equal(144_678 / 2, import.Network.Links.Count);
        Assert.Empty(import.Notes);
        // One of the 259 cells has no node.
        Assert.Equal(258, import.Network.Nodes.Select(node => node.Area).Distinct().Count());
        Assert.Equal(98_228 / 2, import.Network.Links.Count(link => link is { LanesForward: 1, LanesBackward: 1 }));
        Assert.Equal(451, import.Network.Links.Count(link => Math.Max(link.LanesForward, link.LanesBackward) == 4 && link.IsOneWay));
        Assert.Equal(6_447, import.Network.Nodes.Count(node => node.Flags.HasFlag(RoadNodeFlags.Highway)));
        Assert.Equal(3_053, import.Network.Nodes.Count(node => node.Flags.HasFlag(RoadNodeFlags.Junction)));
    }

    [RealWorldFact("nodes.zip")]
    public void Less_than_a_quarter_of_the_road_length_is_in_junctions()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        var curves = new RoadCurves(network);
        var junctions = new JunctionExtents(curves, new LaneModel(network));
        (double length, double inJunctions) = (0, 0);
        for (int link = 0; link < network.Links.Count; link++)
        {
            if (RoadContinuations.IsDrivable(network, network.Links[link]))
            {
                double own = curves.Of(link).Length;
                (double fromStart, double fromEnd) = junctions.Of(link);
                length += own;
                inJunctions += Math.Min(own, fromStart + fromEnd);
            }
        }

        output.WriteLine(FormattableString.Invariant($"{inJunctions / length:0.0000} of {length / 1000:0} km"));
        Assert.InRange(inJunctions / length, 0.1, 0.25);
    }
}
