using System.IO.Compression;
using System.Text;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Every importer reads back the network that a file was written from, as far as the format can hold it.</summary>
public sealed class RoundTripTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("roads").FullName;
    private readonly RoadNetwork _network = RandomRoads.Make(seed: 5, nodeCount: 400, linkCount: 900);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Import_folder_of_ynd_xml_reads_back_the_network()
    {
        foreach ((int area, string text) in YndText.Cells(_network))
        {
            File.WriteAllText(Path.Combine(_folder, $"nodes{area}.ynd.xml"), text);
        }

        RoadImport import = RoadImporter.Import(_folder);

        Assert.Equal("CodeWalker ynd.xml", import.Format);
        Assert.Empty(import.Notes);
        AssertSame(_network, import.Network);
    }

    [Fact]
    public void Import_zip_of_ynd_xml_ignores_the_names_of_its_entries()
    {
        string file = Path.Combine(_folder, "roads.dat");
        using (ZipArchive zip = ZipFile.Open(file, ZipArchiveMode.Create))
        {
            foreach ((int area, string text) in YndText.Cells(_network))
            {
                using var writer = new StreamWriter(zip.CreateEntry($"cell {area}").Open());
                writer.Write(text);
            }
        }

        AssertSame(_network, RoadImporter.Import(file).Network);
    }

    [Fact]
    public void Import_of_one_ynd_xml_omits_and_counts_links_to_other_cells()
    {
        (int area, string text) = YndText.Cells(_network).First();
        RoadImport import = RoadImporter.Import(Written(text));
        int[] inside = [.. Enumerable.Range(0, _network.Nodes.Count).Where(i => _network.Nodes[i].Area == area)];
        int kept = _network.Links.Count(link => inside.Contains(link.From) && inside.Contains(link.To));
        int cut = _network.Links.Count(link => inside.Contains(link.From) != inside.Contains(link.To));

        Assert.Equal(inside.Length, import.Network.Nodes.Count);
        Assert.Equal(kept, import.Network.Links.Count);
        Assert.Equal($"links to cells without a file, left out: {cut}.", Assert.Single(import.Notes));
    }

    [Fact]
    public void Import_ipl_reads_back_the_network() =>
        AssertSame(WithoutCells(_network), RoadImporter.Import(Written(IplText.Of(_network))).Network);

    [Fact]
    public void Nodes_without_game_numbers_have_none_in_csv_and_database()
    {
        RoadNetwork network = RoadImporter.Import(Written(IplText.Of(_network))).Network;
        string file = Written(string.Empty);
        RoadWriter.Write(network, file);
        using var database = new StringWriter();
        NodeDatabaseWriter.Write(new NodeDatabase(new RoadCurves(network), new LaneModel(network)), database);

        AssertSame(network, RoadImporter.Import(file).Network);
        Assert.All(
            database.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1),
            row => Assert.Matches("^,.*,[0-9]+$", row)
        );
    }

    [Fact]
    public void Import_scene_reads_back_the_network() =>
        AssertSame(WithoutCells(_network), RoadImporter.Import(Written(SceneText.Of(_network))).Network);

    [Fact]
    public void Import_dump_restores_everything_a_dump_can_hold()
    {
        var nodes = _network
            .Nodes.Select(node => node with { Flags = node.Flags & DumpText.Flags, Speed = null, Density = null })
            .ToArray();
        var links = _network.Links.Select(link => link with { MedianWidth = null, Flags = RoadLinkFlags.None }).ToArray();
        var held = new RoadNetwork(nodes, links);

        AssertSame(held, RoadImporter.Import(Written(DumpText.Of(held))).Network);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Import_csv_reads_back_everything_in_its_order(bool packed)
    {
        RoadNetwork named = RandomRoads.WithEdges(
            new RoadNetwork(
                [.. _network.Nodes.Select((node, i) => i == 3 ? node with { Street = "Mirror \"Park\", Blvd" } : node)],
                _network.Links
            ),
            seed: 6
        );
        string file = Path.Combine(_folder, packed ? "roads.csv.gz" : "roads.csv");

        RoadWriter.Write(named, file);
        RoadNetwork read = RoadImporter.Import(file).Network;

        Assert.Equal(named.Nodes, read.Nodes);
        Assert.Equal(named.Links, read.Links);
        Assert.NotEmpty(named.Edges);
        Assert.Equal(named.Edges, read.Edges);
        Assert.Equal(packed, File.ReadAllBytes(file) is [0x1F, 0x8B, ..]);
    }

    [Fact]
    public void Write_csv_twice_gives_the_same_bytes_and_no_minus_zero()
    {
        using var first = new StringWriter();
        using var second = new StringWriter();
        RoadCsvWriter.Write(_network, first);
        RoadCsvWriter.Write(RoadCsvReader.Read(new StringReader(first.ToString())), second);

        Assert.Equal(first.ToString(), second.ToString());
        Assert.DoesNotContain("-0,", first.ToString(), StringComparison.Ordinal);
        Assert.DoesNotContain('\r', first.ToString());
    }

    internal static void AssertSame(RoadNetwork expected, RoadNetwork actual)
    {
        Assert.Equal(Ordered(expected.Nodes), Ordered(actual.Nodes));
        Assert.Equal(Described(expected), Described(actual));
    }

    private static IEnumerable<RoadNode> Ordered(IEnumerable<RoadNode> nodes) => nodes.OrderBy(node => node.Number);

    /// <summary>The links by the numbers of their nodes, from the lower one, in order: what they are whichever way each is held.</summary>
    private static IEnumerable<RoadLink> Described(RoadNetwork network) =>
        network
            .Links.Select(link => link with { From = network.Nodes[link.From].Number, To = network.Nodes[link.To].Number })
            .Select(link => link.From < link.To ? link : link.Reversed())
            .OrderBy(link => link.From)
            .ThenBy(link => link.To);

    private static RoadNetwork WithoutCells(RoadNetwork network) =>
        new(
            [.. network.Nodes.Select(node => node with { Area = RoadNode.NoArea, Flags = node.Flags & ~RandomRoads.OfCellsOnly })],
            network.Links
        );

    private string Written(string text)
    {
        string file = Path.Combine(_folder, "roads");
        File.WriteAllText(file, text, new UTF8Encoding(false));
        return file;
    }
}
