using System.IO.Compression;
using System.Text;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Corrupt, truncated and hostile files end in an error with the place, never in another exception or an endless loop.</summary>
public sealed class HostileFileTests : IDisposable
{
    private static readonly RoadNetwork Network = RandomRoads.Make(seed: 11, nodeCount: 6, linkCount: 8);

    private readonly string _file = Path.GetTempFileName();

    public static TheoryData<string> Formats => ["ynd", "ipl", "scene", "dump", "csv", "gzip", "zip"];

    public void Dispose() => File.Delete(_file);

    [Theory]
    [MemberData(nameof(Formats))]
    public void Import_of_a_mutated_file_works_or_fails_with_a_message(string format) => ImportMutated(format, count: 200);

    [Theory]
    [MemberData(nameof(Formats))]
    [Trait("Category", "Heavy")]
    public void Import_of_4000_mutated_files_works_or_fails_with_a_message(string format) => ImportMutated(format, count: 4_000);

    private void ImportMutated(string format, int count)
    {
        byte[] healthy = Bytes(format);
        byte[] values = [.. Enumerable.Range(0, 256).Select(value => (byte)value), .. "0123456789-.,<>\"{}[]e"u8];
        int refused = 0;
        RandomCases.Check(
            count,
            ByteChange.Lists(count: 3, maxLength: 60, values),
            changes =>
            {
                File.WriteAllBytes(_file, ByteChange.Apply(changes, healthy));
                refused += IsRefused() ? 1 : 0;
            }
        );

        // Both outcomes must occur, or the mutations would prove nothing.
        Assert.InRange(refused, count / 10, count - 1);
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void Import_of_a_file_truncated_anywhere_is_refused(string format)
    {
        byte[] healthy = Bytes(format);
        for (int length = 0; length < healthy.Length; length += 29)
        {
            File.WriteAllBytes(_file, healthy[..length]);
            Assert.True(IsRefused(), $"cut off after {length} of {healthy.Length} bytes");
        }
    }

    [Theory]
    [InlineData("ynd", "<VehicleNodeCount value=\"1\"", "<VehicleNodeCount value=\"2\"", "line 2: the file counts 2 nodes but has 1")]
    [InlineData("ynd", "<Flags0 value=\"", "<Flags0 value=\"9", "Flags0 must have value, a whole number from 0 to 255")]
    [InlineData("ynd", "<Position x=\"", "<Position x=\"1e999\" w=\"", "Position must have x, a finite number")]
    [InlineData("scene", "<ref guid=\"{0}\"", "<ref guid=\"{99}\"", "refers to {99}, which is not a node")]
    [InlineData("ipl", "end\nlink\n", "end\nlink\n0, 6, 0, 1, 1, 0\n", "the link runs from node 0 to node 6; there are 6 nodes")]
    [InlineData("ipl", "vnod\n", "vnod\n1, 2\n", "line 4: expected 22 values")]
    [InlineData("csv", "end,6,8", "end,6,9", "line 25: the count of links must be a whole number from 8 to 8, not 9")]
    [InlineData("csv", "\nedge,", "\nedge,8", "link must be a whole number from 0 to 7")]
    [InlineData("csv", "\nend", "\nedge,0,middle,1,2,3\nend", "an edge must be at one end of its link: from or to")]
    [InlineData("csv", "\nend", "\nedge,0,from,1,2\nend", "an edge must have 6 fields")]
    [InlineData("csv", "\nend", "\nlink,0,1,1,1,0,,9\nend", "a link must come before all edges")]
    [InlineData("csv", "\nlink,", "\nlink,6", "must be a whole number from 0 to 5")]
    public void Import_of_an_inconsistent_file_names_the_position(string format, string healthy, string lie, string expected)
    {
        string text = Text(format);
        int at = text.IndexOf(healthy, StringComparison.Ordinal);
        Assert.True(at >= 0, text);
        File.WriteAllText(_file, text[..at] + lie + text[(at + healthy.Length)..]);

        Assert.Contains(
            expected,
            Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(_file)).Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData("<NodeDictionary>&lol2;</NodeDictionary>")]
    [InlineData("<scene><objects><object class=\"vehiclenode\" guid=\"&lol2;\"/></objects></scene>")]
    public void Import_xml_with_entities_is_refused_before_they_are_expanded(string body)
    {
        File.WriteAllText(
            _file,
            "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY lol \"lol\"><!ENTITY lol2 \"&lol;&lol;&lol;\">]>\n" + body
        );

        string message = Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(_file)).Message;

        Assert.Contains("before the outermost element", message, StringComparison.Ordinal);
        Assert.Contains("document types (DTDs) are not allowed", message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("<NodeDictionary>", "<Item>")]
    [InlineData("<scene><objects>", "<object>")]
    [InlineData("", "[")]
    [InlineData("[{\"AreaId\": ", "[")]
    public void Import_of_an_endlessly_nested_file_is_refused(string start, string again)
    {
        const int levels = 100_000;
        File.WriteAllText(_file, start + string.Concat(Enumerable.Repeat(again, levels)));

        Assert.True(IsRefused());
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Import_packed_bomb_is_refused_at_the_limit()
    {
        byte[] spaces = new byte[1 << 20];
        Array.Fill(spaces, (byte)' ');
        using (var gzip = new GZipStream(File.Create(_file), CompressionLevel.Fastest))
        {
            gzip.Write("vnod\n"u8);
            for (int i = 0; i < 1100; i++)
            {
                spaces[^1] = (byte)'\n';
                gzip.Write(spaces);
            }
        }

        Assert.Contains(
            "limit of",
            Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(_file)).Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Import_of_many_files_is_refused_when_too_large_in_total(bool zipped)
    {
        const int cells = 4;
        string folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;
        string[] texts = [.. YndText.Cells(Network).Take(cells).Select(cell => cell.Text)];
        foreach ((string text, int cell) in texts.Select((text, cell) => (text, cell)))
        {
            File.WriteAllText(Path.Combine(folder, $"nodes{cell}.ynd.xml"), text);
        }

        string from = folder;
        if (zipped)
        {
            from = _file;
            File.Delete(_file);
            ZipFile.CreateFromDirectory(folder, _file);
        }

        long all = texts.Sum(text => (long)Encoding.UTF8.GetByteCount(text));

        // Each file is read several times over and counts once.
        Assert.NotEmpty(RoadImporter.Import(from, LanesIn.Forward, all).Network.Nodes);
        string refusal = Assert.Throws<DatasetFormatException>(() => RoadImporter.Import(from, LanesIn.Forward, all - 1)).Message;
        Assert.Equal($"nodes{texts.Length - 1}.ynd.xml: the unpacked files exceed the limit of {all - 1} bytes.", refusal);
        Directory.Delete(folder, recursive: true);
    }

    private static string Text(string format) =>
        format switch
        {
            "ynd" => YndText.Cells(Network).First().Text,
            "ipl" => IplText.Of(Network),
            "scene" => SceneText.Of(Network),
            "dump" => DumpText.Of(new RoadNetwork(Network.Nodes, [.. Network.Links.Select(link => link with { MedianWidth = null })])),
            _ => CsvOf(RandomRoads.WithEdges(Network, seed: 12)),
        };

    /// <summary>A file without a line feed at its end, whose loss would be no harm.</summary>
    private static byte[] Bytes(string format)
    {
        if (format is not ("gzip" or "zip"))
        {
            return Encoding.UTF8.GetBytes(Text(format).TrimEnd());
        }

        using var packed = new MemoryStream();
        if (format == "gzip")
        {
            using var gzip = new GZipStream(packed, CompressionLevel.Optimal, leaveOpen: true);
            gzip.Write(Bytes("csv"));
        }
        else
        {
            using var zip = new ZipArchive(packed, ZipArchiveMode.Create, leaveOpen: true);
            using Stream entry = zip.CreateEntry("roads").Open();
            entry.Write(Bytes("ynd"));
        }

        return packed.ToArray();
    }

    private static string CsvOf(RoadNetwork network)
    {
        using var writer = new StringWriter();
        RoadCsvWriter.Write(network, writer);
        return writer.ToString();
    }

    private bool IsRefused()
    {
        try
        {
            RoadImporter.Import(_file);
            return false;
        }
        catch (DatasetFormatException e)
        {
            Assert.NotEmpty(e.Message);
            return true;
        }
    }
}
