using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Pages.Plots;

/// <summary>Lines and marks over two axes. The style sheet of the page defines colours for their classes.</summary>
public sealed class LinePlot
{
    private const double Width = 960;
    private const double DefaultHeight = 260;
    private const double MapHeight = 620;
    private const double Left = 60;
    private const double Right = 12;
    private const double Top = 10;
    private const double Bottom = 42;
    private const double MarkRadius = 7;
    private const int TickDecimals = 6;

    private readonly double _height;
    private readonly PlotAxis _x;
    private readonly PlotAxis _y;
    private readonly List<PlotLine> _lines = [];
    private readonly List<PlotMark> _marks = [];

    /// <summary>Creates an empty plot.</summary>
    /// <param name="x">The horizontal axis.</param>
    /// <param name="y">The vertical axis.</param>
    public LinePlot(PlotAxis x, PlotAxis y)
        : this(x, y, DefaultHeight) { }

    private LinePlot(PlotAxis x, PlotAxis y, double height)
    {
        _x = x;
        _y = y;
        _height = height;
    }

    /// <summary>Creates a map, north up, with the same scale on both axes.</summary>
    /// <param name="places">Points that the map must include, metres east and north; at least one.</param>
    public static LinePlot Map(IEnumerable<Vector2D> places)
    {
        const double margin = 20;
        Vector2D[] all = [.. places];
        double minX = all.Min(place => place.X) - margin;
        double minY = all.Min(place => place.Y) - margin;
        double spanX = all.Max(place => place.X) + margin - minX;
        double spanY = all.Max(place => place.Y) + margin - minY;
        double metresPerPixel = Math.Max(spanX / (Width - Left - Right), spanY / (MapHeight - Top - Bottom));
        double halfX = metresPerPixel * (Width - Left - Right) / 2;
        double halfY = metresPerPixel * (MapHeight - Top - Bottom) / 2;
        double middleX = minX + (spanX / 2);
        double middleY = minY + (spanY / 2);
        return new LinePlot(
            new PlotAxis("east, m", middleX - halfX, middleX + halfX),
            new PlotAxis("north, m", middleY - halfY, middleY + halfY),
            MapHeight
        );
    }

    /// <summary>Adds a line.</summary>
    public void Add(PlotLine line) => _lines.Add(line);

    /// <summary>Adds a mark.</summary>
    public void Add(PlotMark mark) => _marks.Add(mark);

    /// <summary>Writes the plot as an svg element as wide as its container.</summary>
    public void Write(MarkupWriter page)
    {
        ArgumentNullException.ThrowIfNull(page);
        page.Start("svg").With("class", "plot").With("viewBox", FormattableString.Invariant($"0 0 {Width} {_height}")).With("role", "img");
        page.With("aria-label", $"{_y.Name} over {_x.Name}").NewLine();
        WriteGrid(page);
        foreach (PlotLine line in _lines)
        {
            page.Start("polyline").With("class", line.Style).WithPoints(line.Points.Select(Pixel)).End().NewLine();
        }

        foreach (PlotMark mark in _marks)
        {
            Vector2D centre = Pixel(mark.Place);
            page.Start("circle").With("class", mark.Style).With("cx", centre.X).With("cy", centre.Y).With("r", MarkRadius);
            page.Element("title", mark.Label).End().NewLine();
        }

        page.End().NewLine();
    }

    private void WriteGrid(MarkupWriter page)
    {
        double floor = _height - Bottom;
        foreach (double tick in _x.Ticks())
        {
            double x = Pixel(new Vector2D(tick, 0)).X;
            WriteGridLine(page, new Vector2D(x, Top), new Vector2D(x, floor));
            WriteTick(page, tick, new Vector2D(x, floor + 16), "middle");
        }

        foreach (double tick in _y.Ticks())
        {
            double y = Pixel(new Vector2D(0, tick)).Y;
            WriteGridLine(page, new Vector2D(Left, y), new Vector2D(Width - Right, y));
            WriteTick(page, tick, new Vector2D(Left - 6, y + 4), "end");
        }

        page.Start("text")
            .With("x", (Left + Width - Right) / 2)
            .With("y", _height - 6)
            .With("text-anchor", "middle")
            .Text(_x.Name)
            .End()
            .NewLine();
        page.Start("text").With("transform", FormattableString.Invariant($"translate(14 {(Top + floor) / 2}) rotate(-90)"));
        page.With("text-anchor", "middle").Text(_y.Name).End().NewLine();
    }

    private static void WriteGridLine(MarkupWriter page, Vector2D from, Vector2D to) =>
        page.Start("line").With("class", "grid").With("x1", from.X).With("y1", from.Y).With("x2", to.X).With("y2", to.Y).End();

    private static void WriteTick(MarkupWriter page, double tick, Vector2D place, string anchor) =>
        page.Start("text")
            .With("x", place.X)
            .With("y", place.Y)
            .With("text-anchor", anchor)
            .Text(InvariantNumber.Format(tick, TickDecimals))
            .End()
            .NewLine();

    private Vector2D Pixel(Vector2D point) =>
        new(
            Left + ((point.X - _x.Min) / (_x.Max - _x.Min) * (Width - Left - Right)),
            _height - Bottom - ((point.Y - _y.Min) / (_y.Max - _y.Min) * (_height - Top - Bottom))
        );
}
