using System.IO.Compression;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Tests.Roads;

public sealed class RoadImporterTests : IDisposable
{
    private const string TwoNodes = """
        [{"AreaId": 496, "Nodes": [
          {"Id": 7, "StreetName": "0", "IsValidForGps": true, "IsJunction": true, "Position": {"X": 10.25, "Y": -20.5, "Z": 3.0},
           "ConnectedNodes": [{"Node": {"Id": 8, "Position": {"X": 30.0, "Y": -20.5, "Z": 3.0}, "ConnectedNodes": null}, "LaneCountForward": 2, "LaneCountBackward": 1}]},
          {"Id": 8, "StreetName": "Elgin Ave", "IsFreeway": true, "Position": {"X": 30.0, "Y": -20.5, "Z": 3.0},
           "ConnectedNodes": [{"Node": {"Id": 7, "Position": {"X": 10.25, "Y": -20.5, "Z": 3.0}, "ConnectedNodes": null}, "LaneCountForward": 1, "LaneCountBackward": 2}]}]}]
        """;

    private readonly string _file = Path.GetTempFileName();

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void Import_dump_keeps_each_link_once_and_removes_truncation_bias()
    {
        File.WriteAllText(_file, TwoNodes);

        RoadImport import = RoadImporter.Import(_file);

        Assert.Empty(import.Notes);
        Assert.Equal(new RoadLink(0, 1, 2, 1, null, RoadLinkFlags.None), Assert.Single(import.Network.Links));
        // Half a step further from zero: 10.25 + 0.125, -20.5 - 0.125, 3 + 1/64.
        Assert.Equal(new RoadNode(496, 7, new Vector3D(10.375, -20.625, 3.015625), "", RoadNodeFlags.Junction), import.Network.Nodes[0]);
        Assert.Equal("Elgin Ave", import.Network.Nodes[1].Street);
        Assert.Equal(RoadNodeFlags.Highway | RoadNodeFlags.NoGps, import.Network.Nodes[1].Flags);
    }

    [Fact]
    public void Import_dump_packed_by_gzip_or_zip_is_the_same()
    {
        File.WriteAllText(_file, TwoNodes);
        RoadImport plain = RoadImporter.Import(_file);
        using (var gzip = new GZipStream(File.Create(_file), CompressionLevel.Fastest))
        {
            gzip.Write(System.Text.Encoding.UTF8.GetBytes(TwoNodes));
        }

        Assert.Equal(plain.Network.Nodes, RoadImporter.Import(_file).Network.Nodes);
        using (var zip = new ZipArchive(File.Create(_file), ZipArchiveMode.Create))
        {
            using var writer = new StreamWriter(zip.CreateEntry("anything.txt").Open());
            writer.Write(TwoNodes);
        }

        Assert.Equal(plain.Network.Links, RoadImporter.Import(_file).Network.Links);
    }

    [Fact]
    public void Import_folder_skips_other_lists_dumped_from_the_game()
    {
        string folder = Directory.CreateTempSubdirectory().FullName;
        try
        {
            File.WriteAllText(
                Path.Combine(folder, "lights.json"),
                """[{"Name": "prop_traffic_01d", "Position": {"X": 1, "Y": 2, "Z": 3}}]"""
            );
            File.WriteAllText(Path.Combine(folder, "nodes.json"), TwoNodes);

            Assert.Equal(2, RoadImporter.Import(folder).Network.Nodes.Count);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Theory]
    [InlineData("\"Id\": 8, \"Position\"", "\"Id\": 9, \"Position\"", "node 7 of cell 496 has a neighbour, node 9")]
    [InlineData(
        "\"LaneCountForward\": 2",
        "\"LaneCountForward\": 8",
        "node 7 of cell 496 has a link without a number of lanes from 0 to 7"
    )]
    [InlineData("\"Id\": 8, \"StreetName\"", "\"Id\": \"8\", \"StreetName\"", "line 4")]
    [InlineData("\"LaneCountBackward\": 2}]}]}]", "\"LaneCountBackward\": 2}", "line 5")]
    [InlineData("\"X\": 10.25, \"Y\": -20.5, \"Z\": 3.0},\n   \"Conn", "\"X\": 1e999, \"Y\": -20.5, \"Z\": 3.0},\n   \"Conn", "finite")]
    public void Import_of_a_corrupt_dump_names_the_position(string healthy, string corrupt, string expected)
    {
        string text = TwoNodes.ReplaceLineEndings("\n").Replace(healthy, corrupt, StringComparison.Ordinal);
        Assert.NotEqual(TwoNodes.ReplaceLineEndings("\n"), text);
        File.WriteAllText(_file, text);

        var error = Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(_file));

        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Import_omits_and_notes_a_link_into_a_missing_cell()
    {
        // x = 600 lies one cell of 512 m further east than x = 30.
        File.WriteAllText(
            _file,
            TwoNodes.Replace("\"Id\": 8, \"Position\": {\"X\": 30.0", "\"Id\": 8, \"Position\": {\"X\": 600.0", StringComparison.Ordinal)
        );

        RoadImport import = RoadImporter.Import(_file);

        Assert.Equal("links to cells without a file, left out: 1.", Assert.Single(import.Notes));
        Assert.Single(import.Network.Links);
    }

    [Fact]
    public void Import_takes_a_cell_of_an_update_in_place_of_the_former_one()
    {
        string folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;
        try
        {
            RoadNetwork former = NetworkOf(new Vector3D(0, 0, 30), new Vector3D(30, 0, 30));
            RoadNetwork update = NetworkOf(new Vector3D(0, 0, 30), new Vector3D(0, 60, 30), new Vector3D(0, 90, 30));
            Directory.CreateDirectory(Path.Combine(folder, "update", "deep"));
            File.WriteAllText(Path.Combine(folder, "nodes495.ynd.xml"), YndText.Cells(former).Single().Text);
            File.WriteAllText(Path.Combine(folder, "update", "deep", "nodes495.ynd.xml"), YndText.Cells(update).Single().Text);

            RoadImport import = RoadImporter.Import(folder);

            Assert.Equal(3, import.Network.Nodes.Count);
            Assert.Equal(
                "'update/deep/nodes495.ynd.xml' replaces 'nodes495.ynd.xml', which has the same cell 495.",
                Assert.Single(import.Notes)
            );
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void Import_reports_an_unknown_file_type()
    {
        File.WriteAllText(_file, "no road data at all");

        Assert.Contains(
            "unknown road format",
            Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(_file)).Message,
            StringComparison.Ordinal
        );
    }

    private static RoadNetwork NetworkOf(params Vector3D[] places) =>
        new(
            [.. places.Select((place, number) => new RoadNode(495, number, place, "", default))],
            [.. Enumerable.Range(1, places.Length - 1).Select(number => PathBits.Link(number - 1, number, 0))]
        );
}
