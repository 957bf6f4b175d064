using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class RoadsCommandTests : IDisposable
{
    /// <summary>Three nodes in a line to the north with two links; the first has two lanes north and one south.</summary>
    private const string Ipl = """
        vnod
        0, 0, 10, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
        0, 20, 10, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
        0, 40, 10, 0, 0, 0, 1, 15, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
        end
        link
        0, 1, 2, 2, 1, 0
        1, 2, 0, 1, 0, 1
        end
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Info_after_import_shows_the_content_of_the_source()
    {
        string from = _folder.File("roads.txt", Ipl);
        string csv = Path.Combine(_folder.Path, "roads.csv.gz");

        CliRun import = CliRun.Of("roads", "import", from, "--out", csv);
        CliRun info = CliRun.Of("roads", "info", csv);

        Assert.Equal(0, import.ExitCode);
        Assert.Equal($"{csv}: 3 nodes, 2 links, from paths.ipl\n", import.Out);
        Assert.Equal(0, info.ExitCode);
        Assert.Matches(@"node flag Highway +2\n", info.Out);
        Assert.Matches(@"node flag TrafficLight +1\n", info.Out);
        Assert.Matches(@"link flag NarrowRoad +1\n", info.Out);
        Assert.Matches(@"links with 2 \+ 1 lanes +1\n", info.Out);
        Assert.Matches(@"length +0\.0 km\n", info.Out);
        Assert.Equal(
            ["roads.csv.gz", "roads.txt"],
            Directory.GetFiles(_folder.Path).Select(Path.GetFileName).Order(StringComparer.Ordinal)
        );
    }

    [Fact]
    public void Compare_counts_agreeing_one_way_links_and_honours_lanes_in()
    {
        string ipl = _folder.File("roads.txt", Ipl);
        string csv = Path.Combine(_folder.Path, "roads.csv");
        Assert.Equal(0, CliRun.Of("roads", "import", ipl, "--out", csv).ExitCode);

        CliRun same = CliRun.Of("roads", "compare", ipl, csv);
        CliRun turned = CliRun.Of("roads", "compare", ipl, csv, "--lanes-in", "backward");

        Assert.Equal(0, same.ExitCode);
        Assert.Matches(@"matched with a link of B +2 \(100\.0 %\)\n", same.Out);
        Assert.Matches(@"same direction +1 \(100\.0 %\)\n", same.Out);
        Assert.Matches(@"opposite directions +1 \(100\.0 %\)\n", turned.Out);
        Assert.Equal(2, CliRun.Of("roads", "compare", ipl, csv, "--lanes-in", "sideways").ExitCode);
    }

    [Fact]
    public void Nodes_writes_the_columns_of_figure_22_first()
    {
        string from = _folder.File("roads.txt", Ipl);
        string csv = Path.Combine(_folder.Path, "nodes.csv");

        CliRun run = CliRun.Of("roads", "nodes", from, "--out", csv, "--lane-width", "5");

        string[] lines = File.ReadAllLines(csv);
        Assert.Equal(0, run.ExitCode);
        Assert.StartsWith("nodeId,onMarking,oneWay,leftStart,leftEnd,rightStart,rightEnd,heading,", lines[0], StringComparison.Ordinal);
        // Node 0 northwards: median 2 m, lanes of 5 m, two right of it and one left of it.
        Assert.Contains(",false,false,-1 0 10,-6 0 10,1 0 10,11 0 10,0 1 0,2,1,5,constant,2,0.8,false,0", lines);
    }

    [Fact]
    public void Nodes_of_a_survey_with_road_edges_have_the_measured_width()
    {
        // A lane each way to the north, 4.5 m wide, reported twice at both ends.
        string survey = _folder.File(
            "survey.csv",
            """
            harvester roads,1
            node,0,0,0,0,10,,,,
            node,0,1,0,20,10,,,,
            link,0,1,1,1,0,,20
            edge,0,from,4.5,0,10
            edge,0,to,-4.5,20,10
            edge,0,from,4.5,0,10
            edge,0,to,-4.5,20,10
            end,2,1
            """
        );
        string imported = Path.Combine(_folder.Path, "roads.csv");
        string csv = Path.Combine(_folder.Path, "nodes.csv");

        Assert.Equal(0, CliRun.Of("roads", "import", survey, "--out", imported).ExitCode);
        Assert.Equal(0, CliRun.Of("roads", "nodes", imported, "--out", csv).ExitCode);

        Assert.Contains("1,true,false,0 0 10,-4.5 0 10,0 0 10,4.5 0 10,0 1 0,1,1,4.5,calibrated,0,1,false,0", File.ReadAllLines(csv));
        Assert.Matches(@"links with calibrated lanes +1\n", CliRun.Of("roads", "info", imported).Out);
    }

    // 2000 / 15 * 15 is more than 2000 in doubles.
    [Fact]
    public void Longer_side_of_a_map_has_the_requested_size()
    {
        string from = _folder.File("roads.txt", Ipl);
        string svg = _folder.PathOf("map.svg");

        CliRun run = CliRun.Of("roads", "map", from, "--out", svg, "--area=-5,0,5,15", "--size", "2000");

        Assert.StartsWith($"{svg}: 1334 x 2000 pixels of 0.0075 m; ", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Kinds_of_roads_have_the_colours_of_the_legend()
    {
        string svg = _folder.PathOf("map.svg");
        CliRun.Of("roads", "map", _folder.File("roads.txt", Ipl), "--out", svg, "--area=-20,0,20,40", "--size", "400");

        XElement[] paths = [.. XDocument.Load(svg).Descendants().Where(element => element.Name.LocalName == "path")];

        Assert.Equal(
            ["highway", "one-way", "street", "unpaved", "not drivable", "water"],
            paths[6..].Select(path => path.ElementsAfterSelf().First().Value)
        );
        Assert.Equal(
            paths[..6].Reverse().Select(path => path.Attribute("stroke")!.Value),
            paths[6..].Select(path => path.Attribute("stroke")!.Value)
        );
        Assert.Equal("#dc7814", paths[6].Attribute("stroke")!.Value);
    }

    [Fact]
    public void Map_format_follows_the_file_extension()
    {
        string from = _folder.File("roads.txt", Ipl);
        string png = Path.Combine(_folder.Path, "map.png");
        string svg = Path.Combine(_folder.Path, "map.svg");

        Assert.StartsWith(
            $"{png}: 20 x 40 pixels of 1 m; highways orange, ",
            CliRun.Of("roads", "map", from, "--out", png, "--area=-10,0,10,40", "--size", "40").Out,
            StringComparison.Ordinal
        );
        Assert.Equal(0, CliRun.Of("roads", "map", from, "--out", svg, "--area=-10,0,10,40", "--size", "40").ExitCode);

        Assert.True(File.ReadAllBytes(png) is [0x89, (byte)'P', (byte)'N', (byte)'G', ..]);
        // The link between y = 20 and 40 is a highway at both ends, drawn upwards in the middle of the map.
        Assert.Matches("id=\"highway\"[^/]+d=\"M10 20L10 15L10 10L10 5L10 0\"", File.ReadAllText(svg));
        Assert.DoesNotContain("legend", File.ReadAllText(svg), StringComparison.Ordinal);

        CliRun.Of("roads", "map", from, "--out", svg, "--area=-10,0,10,40", "--size", "400");
        Assert.Contains(">unpaved</text>", File.ReadAllText(svg), StringComparison.Ordinal);
        CliRun.Of("roads", "map", from, "--out", svg, "--area=900,900,999,999").AssertFailed(2, "There are no roads in --area.");
        CliRun
            .Of("roads", "map", from, "--out", "map.bmp")
            .AssertFailed(2, "--out takes a file that ends in .png, .svg, .xodr, .osm, .json or .geojson; or name a --format.");
    }

    [Fact]
    public void Lanes_are_written_as_the_ending_or_the_format_says()
    {
        string from = _folder.File("roads.txt", Ipl);
        string xodr = _folder.PathOf("lanes.xodr");
        string json = _folder.PathOf("lanes.json");

        Assert.Matches($"^{Regex.Escape(xodr)}: [0-9]+ roads? with [0-9]+ lanes?, ", CliRun.Of("roads", "map", from, "--out", xodr).Out);
        Assert.Equal(0, CliRun.Of("roads", "map", from, "--out", json, "--format", "geojson").ExitCode);

        XElement[] lanes = [.. XDocument.Load(xodr).Descendants("lane").Where(lane => lane.Element("userData") is not null)];
        using var features = JsonDocument.Parse(File.ReadAllText(json));
        Assert.NotEmpty(lanes);
        Assert.Equal(lanes.Length, features.RootElement.GetProperty("features").GetArrayLength());
        CliRun
            .Of("roads", "map", from, "--out", json)
            .AssertFailed(2, "A file that ends in .json can be of several formats: name --format nuscenes or --format argoverse2.");
        CliRun
            .Of("roads", "map", from, "--out", json, "--format", "shapefile")
            .AssertFailed(2, "--format takes png, svg, opendrive, lanelet2, nuscenes, argoverse2 or geojson, not 'shapefile'.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lights_of_a_list_and_of_a_session_are_on_the_map()
    {
        string session = _folder.PathOf("session");
        CliRun.Of("harvest", "--out", session, "--frames", "1", "--seed", "2", "--size", "64x48", "--no-report");
        string roads = Path.Combine(session, "scenes", "roads.csv");
        string file = _folder.PathOf("town.geojson");

        Assert.Equal(0, CliRun.Of("roads", "map", roads, "--props", session, "--out", file).ExitCode);
        JsonElement[] lights = Lights(file);
        string[] list =
        [
            .. lights
                .Select(light => light.GetProperty("geometry").GetProperty("coordinates"))
                .Select(place =>
                    $$$"""{"Name": "prop_traffic_01a", "Position": {"X": {{{place[0]}}}, "Y": {{{place[1]}}}, "Z": {{{place[2]}}}}, """
                    + """ "Rotation": {"X": 0, "Y": 0, "Z": 0}}"""
                ),
        ];
        string props = _folder.File("props.json", $"[{string.Join(",", list)}]");
        CliRun run = CliRun.Of("roads", "map", roads, "--props", props, "--out", file);

        Assert.NotEmpty(lights);
        Assert.Equal(lights.Length, Lights(file).Length);
        Assert.Contains($"{lights.Length} signals", run.Out, StringComparison.Ordinal);
        File.Delete(Path.Combine(session, "scenes", "00000000.json"));
        CliRun.Of("roads", "map", roads, "--props", session, "--out", file).AssertFailed(1, "--no-scenes gives no lights and signs.");
    }

    [Fact]
    public void Lanes_of_an_area_are_those_of_the_whole_map_there()
    {
        const string area = "-300,-150,-200,60";
        string from = Path.Combine(RepositoryFolder.Path, "data", "example-roads.csv");
        string whole = _folder.PathOf("whole.geojson");
        string part = _folder.PathOf("part.geojson");
        Assert.Equal(0, CliRun.Of("roads", "map", from, "--out", whole).ExitCode);

        Assert.Equal(0, CliRun.Of("roads", "map", from, "--out", part, "--area=" + area).ExitCode);

        Dictionary<string, JsonElement> all = LanesIn(whole);
        Dictionary<string, JsonElement> cut = LanesIn(part);
        bool IsIn(JsonElement lane) =>
            lane.GetProperty("geometry")
                .GetProperty("coordinates")
                .EnumerateArray()
                .Any(point => point[0].GetDouble() is >= -300 and <= -200 && point[1].GetDouble() is >= -150 and <= 60);
        string[] roads =
        [
            .. all.Where(lane => KindOf(lane.Value) == "lane" && IsIn(lane.Value)).Select(lane => RoadOf(lane.Key)).Distinct(),
        ];
        string[] kept =
        [
            .. all.Keys.Where(id => id.Contains('>') ? id.Split('>').All(end => roads.Contains(RoadOf(end))) : roads.Contains(RoadOf(id))),
        ];
        Assert.NotEmpty(kept);
        Assert.InRange(kept.Length, 1, all.Count - 1);
        Assert.Equal(kept.Order(StringComparer.Ordinal), cut.Keys.Order(StringComparer.Ordinal));
        Assert.All(
            kept,
            id =>
            {
                Assert.Equal(all[id].GetProperty("geometry").GetRawText(), cut[id].GetProperty("geometry").GetRawText());
                foreach (string list in (string[])["predecessors", "successors"])
                {
                    Assert.Equal(NamesOf(all[id], list).Intersect(kept), NamesOf(cut[id], list));
                }

                Assert.Equal(EdgesOf(all[id]), EdgesOf(cut[id]));
            }
        );
        CliRun.Of("roads", "map", from, "--out", part, "--area=90000,90000,99999,99999").AssertFailed(2, "There are no roads in --area.");
    }

    /// <summary>The lanes and ways of a file by their name.</summary>
    private static Dictionary<string, JsonElement> LanesIn(string file) =>
        JsonDocument
            .Parse(File.ReadAllText(file))
            .RootElement.GetProperty("features")
            .EnumerateArray()
            .Where(feature => KindOf(feature) is "lane" or "way")
            .ToDictionary(feature => feature.GetProperty("id").GetString()!);

    private static string? KindOf(JsonElement feature) => feature.GetProperty("properties").GetProperty("kind").GetString();

    /// <summary>The road in the name of a lane, as docs/maps.md has it.</summary>
    private static string RoadOf(string lane) => lane.Split('/')[0];

    private static string[] NamesOf(JsonElement lane, string list) =>
        [.. lane.GetProperty("properties").GetProperty(list).EnumerateArray().Select(name => name.GetString()!)];

    private static (string Left, string Right) EdgesOf(JsonElement lane) =>
        (
            lane.GetProperty("properties").GetProperty("leftEdge").GetRawText(),
            lane.GetProperty("properties").GetProperty("rightEdge").GetRawText()
        );

    private static JsonElement[] Lights(string file) =>
        [
            .. JsonDocument
                .Parse(File.ReadAllText(file))
                .RootElement.GetProperty("features")
                .EnumerateArray()
                .Where(feature => feature.GetProperty("properties").GetProperty("kind").GetString() == "light"),
        ];

    [Fact]
    public void Map_of_nodes_without_a_link_reports_that_there_are_no_roads()
    {
        string from = _folder.File("roads.txt", Ipl.Split("0, 1, 2, 2, 1, 0")[0] + "end\n");

        CliRun.Of("roads", "map", from, "--out", _folder.PathOf("map.png")).AssertFailed(2, "The road data has no roads to draw.");
        CliRun.Of("roads", "map", from, "--out", _folder.PathOf("map.xodr")).AssertFailed(2, "The road data has no roads to draw.");
    }

    [Fact]
    public void Photograph_without_a_node_reports_that_there_are_no_roads()
    {
        string from = _folder.File("roads.csv", "harvester roads,1\nend,0,0\n");

        CliRun.Of("roads", "photograph", "--roads", from, "--out", _folder.PathOf("out")).AssertFailed(2, "The road data has no roads");
    }

    [Fact]
    public void Map_of_endless_lanes_is_refused()
    {
        string nodes = "node,0,0,-90000,0,0,,,,\nnode,0,1,90000,0,0,,,,\n";
        string links = string.Concat(Enumerable.Repeat("link,0,1,7,7,0,,180000\n", 10));
        string from = _folder.File("roads.csv", $"harvester roads,1\n{nodes}{links}end,2,10\n");

        CliRun.Of("roads", "map", from, "--out", _folder.PathOf("map.xodr")).AssertFailed(2, "km of lanes; a map takes 10000 km at most.");
    }

    [Theory]
    [InlineData("--area=-0.01,0,0.01,0.1", "0.00625")] // 0.1 m on 16 pixels
    [InlineData("--area=-10,0,10,40", "2.5")] // 40 m
    [InlineData("--area=-5000,-5000,5555,5000", "660")] // 10,555 m: 659.6875 m a pixel
    [InlineData("--area=-50000,-50000,50000,50000", "6250")] // 100 km
    public void Map_shows_its_scale_in_three_digits(string area, string metres) =>
        Assert.Contains(
            $" pixels of {metres} m;",
            CliRun.Of("roads", "map", _folder.File("roads.txt", Ipl), "--out", _folder.PathOf("map.png"), "--size", "16", area).Out,
            StringComparison.Ordinal
        );

    [Fact]
    public void Import_of_a_corrupt_file_fails_with_the_position()
    {
        string from = _folder.File("roads.txt", Ipl.Replace("0, 1, 2, 2, 1, 0", "0, 9, 2, 2, 1, 0", StringComparison.Ordinal));

        CliRun
            .Of("roads", "import", from, "--out", Path.Combine(_folder.Path, "x.csv"))
            .AssertFailed(1, "roads.txt, line 7: the link runs from node 0 to node 9");
        CliRun.Of("roads", "info", Path.Combine(_folder.Path, "absent")).AssertFailed(3, "absent");
    }
}
