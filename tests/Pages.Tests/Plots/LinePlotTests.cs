using System.Text;
using System.Xml.Linq;
using Harvester.Geometry;
using Harvester.Pages.Plots;

namespace Harvester.Pages.Tests.Plots;

public sealed class LinePlotTests
{
    // A plot is 960 x 260 pixels; its area goes from x = 60 to 948 and from y = 10 to 218.
    [Fact]
    public void Points_lie_to_scale_between_the_axes()
    {
        var plot = new LinePlot(new PlotAxis("x, m", 0, 10), new PlotAxis("y, m", -1, 1));
        plot.Add(new PlotLine("a", [new Vector2D(0, -1), new Vector2D(10, 1), new Vector2D(5, 0)]));

        XElement svg = Written(plot);

        Assert.Equal("60,218 948,10 504,114", svg.Element("polyline")!.Attribute("points")!.Value);
        Assert.Equal("a", svg.Element("polyline")!.Attribute("class")!.Value);
    }

    [Fact]
    public void Ticks_stand_at_their_values_and_axes_have_names()
    {
        XElement svg = Written(new LinePlot(new PlotAxis("time, s", 0, 10), new PlotAxis("<speed>, m/s", -1, 1)));

        // From 0 to 10 with eight steps at most: 0, 2, ... 10; at 4 it is 60 + 0.4 * 888 = 415.2.
        Assert.Equal("415.2", svg.Elements("text").Single(text => text.Value == "4").Attribute("x")!.Value);
        Assert.Equal(
            ["0", "2", "4", "6", "8", "10", "-1", "-0.5", "0", "0.5", "1", "time, s", "<speed>, m/s"],
            svg.Elements("text").Select(text => text.Value)
        );
        Assert.Equal(11, svg.Elements("line").Count());
    }

    [Fact]
    public void Marks_are_rings_with_a_label()
    {
        var plot = new LinePlot(new PlotAxis("x", 0, 10), new PlotAxis("y", -1, 1));
        plot.Add(new PlotMark("bad", new Vector2D(5, 0), "a < b"));

        XElement ring = Written(plot).Element("circle")!;

        Assert.Equal(("bad", "504", "114"), (ring.Attribute("class")!.Value, ring.Attribute("cx")!.Value, ring.Attribute("cy")!.Value));
        Assert.Equal("a < b", ring.Element("title")!.Value);
    }

    [Fact]
    public void Map_has_the_same_scale_on_both_axes()
    {
        LinePlot map = LinePlot.Map([new Vector2D(0, 0), new Vector2D(100, 300)]);
        map.Add(new PlotLine("square", [new Vector2D(0, 0), new Vector2D(100, 0), new Vector2D(100, 100)]));

        double[][] points =
        [
            .. Written(map)
                .Element("polyline")!
                .Attribute("points")!
                .Value.Split(' ')
                .Select(point => point.Split(',').Select(double.Parse).ToArray()),
        ];

        // North is up; a coordinate is written to 0.1 pixel.
        Assert.Equal(points[1][0] - points[0][0], points[1][1] - points[2][1], 0.1001);
        Assert.True(points[1][1] > points[2][1] && points[1][0] > points[0][0]);
    }

    [Theory]
    [InlineData(0, 10, "0 2 4 6 8 10")]
    [InlineData(-0.3, 0.3, "-0.3 -0.2 -0.1 0 0.1 0.2 0.3")]
    [InlineData(3, 11, "3 4 5 6 7 8 9 10 11")]
    [InlineData(0, 4100, "0 1000 2000 3000 4000")]
    public void Ticks_are_round_values(double min, double max, string expected) =>
        Assert.Equal(
            expected,
            string.Join(' ', new PlotAxis("", min, max).Ticks().Select(tick => FormattableString.Invariant($"{tick + 0.0:0.######}")))
        );

    [Fact]
    public void Axis_around_a_single_value_is_not_empty() => Assert.Equal(new PlotAxis("x", 4, 6), PlotAxis.Around("x", 5, 5));

    private static XElement Written(LinePlot plot)
    {
        using var stream = new MemoryStream();
        HtmlPage.Write(stream, "plot", "", plot.Write);
        return XDocument.Parse(Encoding.UTF8.GetString(stream.ToArray())).Root!.Element("body")!.Element("svg")!;
    }
}
