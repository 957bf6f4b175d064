using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;

namespace Harvester.Sessions.Tests.Roads;

public sealed class PaintCsvTests
{
    private static readonly RoadNetwork s_network = Network(0, 40, 80, 120);

    private static readonly PaintTable s_table = new(
        s_network,
        [
            new LinkPaint(
                0,
                0,
                40,
                [
                    new LinePaint(0, 40, -3.1234, -3.1, new MarkingPaint(MarkingStyle.Solid, MarkingColour.Yellow, 0.15))
                    {
                        SigmaMetres = 0.012,
                        Images = 7,
                    },
                    new LinePaint(1.5, 20, 0.5, 0.6, new MarkingPaint(MarkingStyle.Dashed, MarkingColour.White, 0.1))
                    {
                        Dashes = new DashPattern(3, 9, 4.25),
                        SigmaMetres = 0.02,
                        Images = 1,
                    },
                ]
            ),
            new LinkPaint(2, 3.5, 39, []),
        ]
    );

    [Fact]
    public void TableSurvivesTheFile()
    {
        PaintTable read = Read(Text(s_table), s_network);

        Assert.Equal(Text(s_table), Text(read));
        Assert.Equal(s_table.Of(0)!.Lines, read.Of(0)!.Lines);
        Assert.Null(read.Of(1));
        Assert.Empty(read.Of(2)!.Lines);
    }

    [Fact]
    public void LinksAreFoundByTheirEnds()
    {
        PaintTable read = Read(Text(s_table), Network(80, 120));

        Assert.Equal([0], read.Links.Select(link => link.Link));
        Assert.Equal(3.5, read.Of(0)!.SeenFrom);
        Assert.Equal(1, read.AbsentLinks);
    }

    [Fact]
    public void TableOfOtherRoadsIsRefused()
    {
        FormatException error = Assert.Throws<FormatException>(() => Read(Text(s_table), Network(0.5, 40.5)));

        Assert.Equal("none of its 2 links is in these roads; the table was measured on another road network.", error.Message);
    }

    [Theory]
    [InlineData("harvester paint,1", "harvester paint,2", "line 1: the first line must be harvester paint,1.")]
    [InlineData("line,0,0,40", "line,1,0,40", "line 5: a line must follow its link.")]
    [InlineData("line,0,0,40", "line,0,0,40.1", "line 5: toStation must be a number from 0 to 40.001, not 40.1.")]
    [InlineData("line,0,0,40", "line,0,40,40", "line 5: toStation must be greater than fromStation.")]
    [InlineData(",yellow,", ",pink,", "line 5: unknown colour: pink.")]
    [InlineData(",dashed,", ",solid,", "line 6: only a dashed line has dashes.")]
    [InlineData(",3,9,4.25,", ",3,3,0,", "line 6: dashPeriod must be greater than dashLength.")]
    [InlineData(",0.02,1\n", ",0,1\n", "line 6: sigma must be greater than 0.")]
    [InlineData(",0.02,1\n", ",0.02,0\n", "line 6: images must be a whole number from 1 to 2147483647, not 0.")]
    [InlineData(",0.02,1\n", ",0.02\n", "line 6: a line has 14 fields.")]
    [InlineData("3.5,39", "3.5,3.5", "line 7: seenTo must be greater than seenFrom.")]
    [InlineData("link,2,80,0,3,120", "link,0,0,0,3,40", "line 7: the link is listed twice.")]
    [InlineData("end,2,2", "end,2,1", "line 8: the count of lines must be a whole number from 2 to 2, not 1.")]
    [InlineData("end,2,2\n", "", "line 7: the file ends before its last line, which begins with end.")]
    [InlineData(",-3.1234,", ",NaN,", "line 5: fromOffset must be a number from -100000 to 100000, not NaN.")]
    public void DamageIsReportedWithItsLine(string text, string damage, string message)
    {
        string whole = Text(s_table);
        Assert.Contains(text, whole, StringComparison.Ordinal);

        FormatException error = Assert.Throws<FormatException>(() =>
            Read(whole.Replace(text, damage, StringComparison.Ordinal), s_network)
        );

        Assert.Equal(message, error.Message);
    }

    private static RoadNetwork Network(params double[] places) =>
        new(
            [.. places.Select((x, i) => new RoadNode(RoadNode.NoArea, i, new Vector3D(x, 0, 3), "", RoadNodeFlags.None))],
            [.. Enumerable.Range(0, places.Length - 1).Select(i => new RoadLink(i, i + 1, 1, 1, null, RoadLinkFlags.None))]
        );

    private static string Text(PaintTable table)
    {
        var text = new StringWriter();
        PaintCsvWriter.Write(table, text);
        return text.ToString();
    }

    private static PaintTable Read(string text, RoadNetwork network) => PaintCsvReader.Read(new StringReader(text), network);
}
