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

    private static readonly PaintTable s_marked = new(s_network, s_table.Links)
    {
        Marks =
        [
            new MarkPaint(new PaintedMark(MarkKind.StopLine, [new(30, 0, 3), new(30.5, 0, 3), new(30.5, 5.1234, 3)]))
            {
                SigmaMetres = 0.05,
                Images = 4,
            },
            new MarkPaint(new PaintedMark(MarkKind.Crossing, [new(32, -5, 3), new(35, -5, 3), new(35, 5, 3), new(32, 5, 3.25)]))
            {
                SigmaMetres = 0.1,
                Images = 2,
            },
        ],
    };

    [Fact]
    public void MarksSurviveTheFile()
    {
        string text = Text(s_marked);
        PaintTable read = Read(text, s_network);

        Assert.Equal(text, Text(read));
        Assert.Equal(
            s_marked.Marks.Select(mark => (mark.Mark.Kind, mark.SigmaMetres, mark.Images)),
            read.Marks.Select(mark => (mark.Mark.Kind, mark.SigmaMetres, mark.Images))
        );
        Assert.Equal(s_marked.Marks.SelectMany(mark => mark.Mark.Corners), read.Marks.SelectMany(mark => mark.Mark.Corners));
        Assert.Contains("mark,stopLine,0.05,4,30,0,3,30.5,0,3,30.5,5.1234,3\n", text, StringComparison.Ordinal);
        Assert.EndsWith("\nend,2,2,2\n", text, StringComparison.Ordinal);
    }

    [Fact]
    public void MarksOfAPartOfTheRoadsAreKept() => Assert.Equal(2, Read(Text(s_marked), Network(80, 120)).Marks.Count);

    [Theory]
    [InlineData("mark,stopLine,", "mark,stop,", "line 9: unknown class: stop.")]
    [InlineData(",0.05,4,", ",0,4,", "line 9: sigma must be greater than 0.")]
    [InlineData(",0.05,4,", ",0.05,0,", "line 9: images must be a whole number from 1 to 2147483647, not 0.")]
    [InlineData(",30.5,5.1234,3\n", "\n", "line 9: a mark has 4 fields and 3 for each of 3 to 64 corners.")]
    [InlineData(",30.5,5.1234,3\n", ",30.5,5.1234\n", "line 9: a mark has 4 fields and 3 for each of 3 to 64 corners.")]
    [InlineData(",5.1234,", ",1e3,", "line 9: y must be a number from -100000 to 100000, not 1e3.")]
    [InlineData("mark,crossing", "link,1", "line 10: a link has 10 fields.")]
    [InlineData("end,2,2,2", "end,2,2", "line 11: the last line must have the numbers of links and lines, and of marks if there are any.")]
    [InlineData("end,2,2,2", "end,2,2,1", "line 11: the count of marks must be a whole number from 2 to 2, not 1.")]
    public void DamagedMarkIsReportedWithItsLine(string text, string damage, string message) =>
        AssertDamage(Text(s_marked), text, damage, message);

    [Theory]
    [InlineData("line,0,0,40,0,0,solid,white,0.15,,,,0.1,1", "line 5: a line must follow its link.")]
    [InlineData("link,1,40,0,3,80,0,3,0,40", "line 5: a link must come before the marks.")]
    public void NothingButMarksFollowsAMark(string row, string message)
    {
        string text = $"harvester paint,1\nlink,0,0,0,3,40,0,3,0,40\n\nmark,crossing,1,1,0,0,3,1,0,3,1,1,3\n{row}\nend,1,0,1\n";

        Assert.Equal(message, Assert.Throws<FormatException>(() => Read(text, s_network)).Message);
    }

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
    public void DamageIsReportedWithItsLine(string text, string damage, string message) =>
        AssertDamage(Text(s_table), text, damage, message);

    private static void AssertDamage(string whole, string text, string damage, string message)
    {
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
