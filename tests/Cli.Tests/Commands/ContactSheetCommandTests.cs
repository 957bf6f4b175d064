using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class ContactSheetCommandTests : IDisposable
{
    private const int TileWidth = 240;
    private const int TileHeight = 48;
    private const int Gap = 4;
    private const int Caption = 20;
    private const int CaptionLine = 16;

    private readonly TemporaryFolder _folder = new();
    private readonly string _roads;
    private readonly string _out;

    public ContactSheetCommandTests()
    {
        _roads = _folder.PathOf("roads.csv");
        _out = _folder.PathOf("sheet.png");
        RoadNode[] nodes =
        [
            .. Enumerable.Range(0, 101).Select(i => new RoadNode(0, i, new Vector3D(0, 10 * i, 0), "", RoadNodeFlags.None)),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, 100).Select(i => new RoadLink(i, i + 1, 1, 1, 0, RoadLinkFlags.None))];
        using StreamWriter writer = File.CreateText(_roads);
        RoadCsvWriter.Write(new RoadNetwork(nodes, links), writer);
    }

    [Fact]
    public void Sheet_has_a_row_per_weather_and_a_column_per_time()
    {
        CliRun run = Sheet(
            "--at",
            "0,100",
            "--at",
            "0,800",
            "--weather",
            "clear",
            "--weather",
            "foggy",
            "--time",
            "12:00",
            "--time",
            "23:00"
        );

        Assert.Equal("", run.Error);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        (int width, int height, byte[] rgb) = Decoded();
        Assert.Equal((2 * (TileWidth + Gap)) + Gap, width);
        Assert.Equal((4 * (TileHeight + Caption)) + Gap, height);
        byte[][] tiles = [.. Enumerable.Range(0, 8).Select(tile => Cut(rgb, width, tile % 2, tile / 2))];
        for (int i = 0; i < tiles.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                Assert.NotEqual(tiles[i], tiles[j]);
            }
        }

        // The second column shows the night, whose sky is dark.
        Assert.All([0, 2, 4, 6], day => Assert.True(Sky(tiles[day]) > 1.5 * Sky(tiles[day + 1]), $"Tile {day}"));
    }

    [Theory]
    [InlineData("--weather", "foggy")]
    [InlineData("--time", "23:00")]
    public void Sheet_has_a_row_per_place_if_one_thing_varies(string option, string value)
    {
        Sheet("--at", "0,100", "--at", "0,800", "--weather", "clear", "--time", "12:00", option, value);

        (int width, int height, _) = Decoded();
        Assert.Equal((2 * (TileWidth + Gap)) + Gap, width);
        Assert.Equal((2 * (TileHeight + Caption)) + Gap, height);
    }

    [Fact]
    public void Detail_is_full_unless_plain_is_asked_for()
    {
        Sheet();
        byte[] byDefault = File.ReadAllBytes(_out);
        Sheet("--detail", "full");
        Assert.Equal(byDefault, File.ReadAllBytes(_out));
        Sheet("--detail", "plain");
        Assert.NotEqual(byDefault, File.ReadAllBytes(_out));
    }

    [Fact]
    public void Long_caption_is_written_on_several_lines()
    {
        // A line of 240 pixels has room for 25 letters of 9.
        Sheet("--list", Write("A long name of a place at the northern end,0,900"));
        (_, int height, byte[] rgb) = Decoded();
        Sheet("--list", Write("A long name of a place at the northern edge,0,900"));
        (_, int sameHeight, byte[] other) = Decoded();

        // "A LONG NAME OF A PLACE AT", "THE NORTHERN END  0,900", "CLEAR 12:00 1 S"
        Assert.Equal(Gap + TileHeight + Caption + (2 * CaptionLine), height);
        Assert.Equal(height, sameHeight);
        Assert.NotEqual(rgb, other);
    }

    [Fact]
    public void Sheet_of_same_options_has_same_bytes()
    {
        Sheet("--places", "3", "--seed", "7");
        byte[] first = File.ReadAllBytes(_out);
        Sheet("--places", "3", "--seed", "7");
        Assert.Equal(first, File.ReadAllBytes(_out));
        Sheet("--places", "3", "--seed", "8");
        Assert.NotEqual(first, File.ReadAllBytes(_out));
    }

    [Fact]
    public void Ego_drives_on_between_moments()
    {
        Sheet("--seconds", "4", "--seconds", "0");

        (int width, _, byte[] rgb) = Decoded();
        Assert.NotEqual(Cut(rgb, width, 0, 0), Cut(rgb, width, 1, 0));
        byte[] moments = File.ReadAllBytes(_out);
        Sheet("--seconds", "0", "--seconds", "4");
        Assert.Equal(moments, File.ReadAllBytes(_out));
    }

    [Fact]
    public void Captions_tell_the_places_apart()
    {
        string list = Write("# a comment\nname,x,y\n\nNorth end,0,900\n");
        Sheet("--list", list);
        (int width, int height, byte[] named) = Decoded();
        Sheet("--at", "0,900");
        byte[] unnamed = Decoded().Rgb;

        Assert.Equal(Cut(named, width, 0, 0), Cut(unnamed, width, 0, 0));
        int belowPicture = (Gap + TileHeight) * width * 3;
        Assert.NotEqual(named[belowPicture..], unnamed[belowPicture..]);
        Assert.Equal(Gap + TileHeight + Caption + CaptionLine, height);
    }

    [Theory]
    [InlineData("South end;0;100", "places.csv, line 1: expected name,x,y, found 'South end;0;100'.")]
    [InlineData("name,x,y\nSouth end,0", "places.csv, line 2: expected name,x,y, found 'South end,0'.")]
    [InlineData("South end,0,nan", "places.csv, line 1: expected name,x,y, found 'South end,0,nan'.")]
    [InlineData("name,x,y\n", "places.csv: no place in it; expected lines of name,x,y.")]
    public void Bad_list_is_bad_data(string text, string message) => Sheet("--list", Write(text)).AssertFailed(ExitCode.BadData, message);

    [Theory]
    [InlineData("--at", "1;2", "--at takes two numbers, e.g. 0,-1000, not '1;2'.")]
    [InlineData("--at", "9000,9000", "No road lies within")]
    [InlineData("--weather", "hail", "not 'hail'.")]
    [InlineData("--time", "25:00", "--time takes a time of day, e.g. 18:30, not '25:00'.")]
    [InlineData("--seconds", "-1", "--seconds takes a number from 0 to 600, not '-1'.")]
    [InlineData("--places", "12", "The road network has only ")]
    [InlineData("--size", "8192x8192", "pixels, more than 16384 a side; give fewer tiles or a smaller --size.")]
    [InlineData("--size", "8000x8000", "pixels, more than 50000000 in all; give fewer tiles or a smaller --size.")]
    public void Bad_value_is_a_usage_error(string option, string value, string message)
    {
        string[] more = option == "--size" ? ["--seconds", "1", "--seconds", "2"] : [];
        CliRun.Of(["contact-sheet", "--out", _out, "--roads", _roads, option, value, .. more]).AssertFailed(ExitCode.Usage, message);
        Assert.False(File.Exists(_out));
    }

    [Fact]
    public void Missing_folder_is_an_error_of_files() =>
        CliRun
            .Of("contact-sheet", "--out", _folder.PathOf(Path.Combine("none", "sheet.png")), "--roads", _roads, "--size", "64x48")
            .AssertFailed(ExitCode.InputOutput, "none");

    public void Dispose() => _folder.Dispose();

    private CliRun Sheet(params string[] arguments) =>
        CliRun.Of([
            "contact-sheet",
            "--out",
            _out,
            "--roads",
            _roads,
            "--size",
            string.Create(CultureInfo.InvariantCulture, $"{TileWidth}x{TileHeight}"),
            .. arguments,
        ]);

    private string Write(string text)
    {
        string path = _folder.PathOf("places.csv");
        File.WriteAllText(path, text);
        return path;
    }

    private (int Width, int Height, byte[] Rgb) Decoded()
    {
        TestPngDecoder picture = TestPngDecoder.Decode(File.ReadAllBytes(_out));
        return (picture.Width, picture.Height, picture.Samples);
    }

    /// <summary>Brightness of the first row of a tile.</summary>
    /// <summary>Brightness of the middle third of the uppermost row: the sky over the road, between the buildings beside it.</summary>
    private static double Sky(byte[] tile) => tile.Skip(TileWidth).Take(TileWidth).Average(value => (double)value);

    private static byte[] Cut(byte[] rgb, int width, int column, int row)
    {
        int left = Gap + (column * (TileWidth + Gap));
        int top = Gap + (row * (TileHeight + Caption));
        return [.. Enumerable.Range(top, TileHeight).SelectMany(y => rgb.Skip(((y * width) + left) * 3).Take(TileWidth * 3))];
    }
}
