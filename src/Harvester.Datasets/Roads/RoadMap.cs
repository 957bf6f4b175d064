using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Roads;

/// <summary>A map of a network, north up, with roads coloured by kind: orange highways, blue one-way roads, brown unpaved ways.</summary>
public sealed class RoadMap
{
    private const double StreetWidthPixels = 1.6;
    private const double MarginFraction = 0.02;
    private const int SvgDecimals = 1;
    private const int MinSideWithLegend = 200;

    /// <summary>Straight pieces in which a curve is drawn.</summary>
    private const int Pieces = 4;

    private readonly RoadCurves _curves;
    private readonly double _west;
    private readonly double _north;
    private readonly double _pixelsPerMetre;

    /// <summary>Prepares a map.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="area">The part to show, metres, world: x to the east, y to the north; all of it when null.</param>
    /// <param name="longSidePixels">Pixels of the map's longer side; at least 16.</param>
    /// <exception cref="ArgumentException">The network has no nodes, or the area is empty.</exception>
    public RoadMap(RoadNetwork network, Box2D? area, int longSidePixels)
    {
        ArgumentNullException.ThrowIfNull(network);
        ArgumentOutOfRangeException.ThrowIfLessThan(longSidePixels, 16);
        Box2D shown = area ?? Bounds(network);
        double width = shown.XMax - shown.XMin;
        double height = shown.YMax - shown.YMin;
        if (!(width > 0 && height > 0))
        {
            throw new ArgumentException("The area to draw is empty.", nameof(area));
        }

        _curves = new RoadCurves(network);
        _west = shown.XMin;
        _north = shown.YMax;
        _pixelsPerMetre = longSidePixels / Math.Max(width, height);
        Size = new ImageSize(Math.Max(1, (int)Math.Ceiling(width * _pixelsPerMetre)), Math.Max(1, (int)Math.Ceiling(height * _pixelsPerMetre)));
    }

    /// <summary>Size of the map.</summary>
    public ImageSize Size { get; }

    /// <summary>How many metres a pixel is wide and high.</summary>
    public double MetresPerPixel => 1 / _pixelsPerMetre;

    /// <summary>Whether there is any road to see.</summary>
    public bool HasRoads => RoadMapStyle.InOrder.Any(style => Lines(style).Any());

    /// <summary>Draws the map as a picture.</summary>
    public PixelBuffer Draw()
    {
        var canvas = new MapCanvas(Size);
        foreach (RoadMapStyle style in RoadMapStyle.InOrder)
        {
            foreach (Vector2D[] line in Lines(style))
            {
                for (int i = 1; i < line.Length; i++)
                {
                    canvas.DrawLine(line[i - 1], line[i], style.Weight * StreetWidthPixels, style);
                }
            }
        }

        return canvas.Picture;
    }

    /// <summary>Writes the map as a vector graphic with a path for each kind of road, and with a legend if it is not tiny.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void WriteSvg(TextWriter text)
    {
        ArgumentNullException.ThrowIfNull(text);
        text.Write(string.Create(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Size.Width} {Size.Height}\" width=\"{Size.Width}\" height=\"{Size.Height}\">\n"));
        text.Write("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
        foreach (RoadMapStyle style in RoadMapStyle.InOrder)
        {
            text.Write(string.Create(CultureInfo.InvariantCulture, $"<path id=\"{style.Name.Replace(' ', '-')}\" fill=\"none\" stroke=\"{ColourOf(style)}\" stroke-width=\"{style.Weight * StreetWidthPixels:0.##}\" stroke-linecap=\"round\" d=\""));
            foreach (Vector2D[] line in Lines(style))
            {
                text.Write(PathOf(line));
            }

            text.Write("\"/>\n");
        }

        if (Math.Min(Size.Width, Size.Height) >= MinSideWithLegend)
        {
            WriteLegend(text);
        }

        text.Write("</svg>\n");
    }

    private static void WriteLegend(TextWriter text)
    {
        const int left = 10;
        const int lineHeight = 16;
        const int sampleLength = 24;
        text.Write("<g id=\"legend\" font-family=\"sans-serif\" font-size=\"11\">\n");
        text.Write(string.Create(CultureInfo.InvariantCulture, $"<rect width=\"110\" height=\"{lineHeight * (RoadMapStyle.InOrder.Length + 1)}\" fill=\"#ffffff\" fill-opacity=\"0.8\"/>\n"));
        foreach ((int index, RoadMapStyle style) in RoadMapStyle.InOrder.Reverse().Index())
        {
            int y = lineHeight * (index + 1);
            text.Write(string.Create(CultureInfo.InvariantCulture, $"<path stroke=\"{ColourOf(style)}\" stroke-width=\"3\" d=\"M{left} {y}h{sampleLength}\"/>"));
            text.Write(string.Create(CultureInfo.InvariantCulture, $"<text x=\"{left + sampleLength + 6}\" y=\"{y + 4}\">{style.Name}</text>\n"));
        }

        text.Write("</g>\n");
    }

    private static string ColourOf(RoadMapStyle style) => string.Create(CultureInfo.InvariantCulture, $"#{style.Red:x2}{style.Green:x2}{style.Blue:x2}");

    private static string PathOf(Vector2D[] line)
    {
        var path = new StringBuilder();
        for (int i = 0; i < line.Length; i++)
        {
            path.Append(i == 0 ? 'M' : 'L');
            InvariantNumber.Append(path, line[i].X, SvgDecimals);
            path.Append(' ');
            InvariantNumber.Append(path, line[i].Y, SvgDecimals);
        }

        return path.ToString();
    }

    private static Box2D Bounds(RoadNetwork network)
    {
        if (network.Nodes.Count == 0)
        {
            throw new ArgumentException("There are no roads to draw.", nameof(network));
        }

        double west = network.Nodes.Min(node => node.Position.X);
        double east = network.Nodes.Max(node => node.Position.X);
        double south = network.Nodes.Min(node => node.Position.Y);
        double north = network.Nodes.Max(node => node.Position.Y);
        double margin = (MarginFraction * Math.Max(east - west, north - south)) + 1;
        return new Box2D(west - margin, south - margin, east + margin, north + margin);
    }

    /// <summary>The lines of a kind that touch the map, in pixels.</summary>
    private IEnumerable<Vector2D[]> Lines(RoadMapStyle style)
    {
        RoadNetwork network = _curves.Network;
        for (int i = 0; i < network.Links.Count; i++)
        {
            if (RoadMapStyle.Of(network, network.Links[i]) != style)
            {
                continue;
            }

            Vector2D[] line = [.. Enumerable.Range(0, Pieces + 1).Select(step => Pixel(_curves.Of(i).PointAt(step / (double)Pieces)))];
            if (line.Max(point => point.X) >= 0 && line.Min(point => point.X) <= Size.Width && line.Max(point => point.Y) >= 0 && line.Min(point => point.Y) <= Size.Height)
            {
                yield return line;
            }
        }
    }

    private Vector2D Pixel(Vector3D place) => new((place.X - _west) * _pixelsPerMetre, (_north - place.Y) * _pixelsPerMetre);
}
