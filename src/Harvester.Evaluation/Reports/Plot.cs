using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Harvester.Geometry;

namespace Harvester.Evaluation.Reports;

/// <summary>Draws lines and marks over two axes as SVG.</summary>
internal sealed class Plot
{
    private const double Width = 960;
    private const double Left = 60;
    private const double Right = 12;
    private const double Top = 10;
    private const double Bottom = 42;
    private const int MaxTicks = 8;

    private readonly string _xName;
    private readonly string _yName;
    private readonly double _height;
    private readonly (double Min, double Max) _x;
    private readonly (double Min, double Max) _y;
    private readonly StringBuilder _content = new();

    private Plot(string xName, string yName, double height, (double Min, double Max) x, (double Min, double Max) y)
    {
        _xName = xName;
        _yName = yName;
        _height = height;
        _x = x;
        _y = y;
    }

    /// <summary>A plot whose axes hold given ranges.</summary>
    public static Plot Of(string xName, string yName, (double Min, double Max) x, (double Min, double Max) y) =>
        new(xName, yName, 260, Widened(x), Widened(y));

    /// <summary>A map: the same scale on both axes.</summary>
    public static Plot Map(IEnumerable<Vector2D> places)
    {
        const double height = 620;
        const double margin = 20;
        Vector2D[] all = [.. places];
        double minX = all.Min(place => place.X) - margin;
        double minY = all.Min(place => place.Y) - margin;
        double spanX = all.Max(place => place.X) + margin - minX;
        double spanY = all.Max(place => place.Y) + margin - minY;
        double metresByPixel = Math.Max(spanX / (Width - Left - Right), spanY / (height - Top - Bottom));
        double halfX = metresByPixel * (Width - Left - Right) / 2;
        double halfY = metresByPixel * (height - Top - Bottom) / 2;
        double middleX = minX + (spanX / 2);
        double middleY = minY + (spanY / 2);
        return new Plot("east, m", "north, m", height, (middleX - halfX, middleX + halfX), (middleY - halfY, middleY + halfY));
    }

    public void Add(PlotLine line)
    {
        _content.Append(CultureInfo.InvariantCulture, $"<polyline class=\"{line.Style}\" points=\"");
        foreach (Vector2D point in line.Points)
        {
            _content.Append(CultureInfo.InvariantCulture, $"{AtX(point.X):0.0},{AtY(point.Y):0.0} ");
        }

        _content.Append("\"/>\n");
    }

    /// <summary>A ring around a place, with words that show when pointed at.</summary>
    public void Mark(string style, Vector2D place, string words) => _content.Append(
        CultureInfo.InvariantCulture,
        $"<circle class=\"{style}\" cx=\"{AtX(place.X):0.0}\" cy=\"{AtY(place.Y):0.0}\" r=\"7\"><title>{words}</title></circle>\n");

    public string ToSvg()
    {
        StringBuilder svg = new();
        svg.Append(CultureInfo.InvariantCulture, $"<svg viewBox=\"0 0 {Width} {_height}\" role=\"img\">\n");
        foreach (double x in Ticks(_x))
        {
            svg.Append(CultureInfo.InvariantCulture, $"<line class=\"grid\" x1=\"{AtX(x):0.0}\" x2=\"{AtX(x):0.0}\" y1=\"{Top}\" y2=\"{_height - Bottom}\"/><text x=\"{AtX(x):0.0}\" y=\"{_height - Bottom + 16}\" text-anchor=\"middle\">{x:0.###}</text>\n");
        }

        foreach (double y in Ticks(_y))
        {
            svg.Append(CultureInfo.InvariantCulture, $"<line class=\"grid\" x1=\"{Left}\" x2=\"{Width - Right}\" y1=\"{AtY(y):0.0}\" y2=\"{AtY(y):0.0}\"/><text x=\"{Left - 6}\" y=\"{AtY(y) + 4:0.0}\" text-anchor=\"end\">{y:0.###}</text>\n");
        }

        svg.Append(_content);
        svg.Append(CultureInfo.InvariantCulture, $"<text x=\"{(Left + Width - Right) / 2}\" y=\"{_height - 6}\" text-anchor=\"middle\">{_xName}</text>\n");
        svg.Append(CultureInfo.InvariantCulture, $"<text transform=\"translate(14 {(Top + _height - Bottom) / 2}) rotate(-90)\" text-anchor=\"middle\">{_yName}</text>\n</svg>\n");
        return svg.ToString();
    }

    private static (double Min, double Max) Widened((double Min, double Max) range)
    {
        double span = range.Max - range.Min;
        double margin = span > 0 ? 0.04 * span : 1;
        return (range.Min - margin, range.Max + margin);
    }

    private static IEnumerable<double> Ticks((double Min, double Max) range)
    {
        double least = (range.Max - range.Min) / MaxTicks;
        double power = Math.Pow(10, Math.Floor(Math.Log10(least)));
        double step = power * (least <= power ? 1 : least <= 2 * power ? 2 : least <= 5 * power ? 5 : 10);
        for (double tick = Math.Ceiling(range.Min / step); tick * step <= range.Max; tick++)
        {
            yield return (tick * step) + 0.0;
        }
    }

    private double AtX(double x) => Left + ((x - _x.Min) / (_x.Max - _x.Min) * (Width - Left - Right));

    private double AtY(double y) => _height - Bottom - ((y - _y.Min) / (_y.Max - _y.Min) * (_height - Top - Bottom));
}
