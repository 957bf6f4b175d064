using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Pages;
using Harvester.Reports.Drawing;
using Harvester.Sessions.Imaging;

namespace Harvester.Reports.Maps;

/// <summary>A map of a road network, north up, with roads coloured by kind, or with their lanes.</summary>
public sealed class RoadMap
{
    private const double StreetWidthPixels = 1.6;
    private const double MarginFraction = 0.02;
    private const int WidthDecimals = 2;
    private const int MinSideWithLegend = 200;

    /// <summary>Number of straight segments in which a curve is drawn.</summary>
    private const int Pieces = 4;

    /// <summary>Fractions of a pixel below this are rounding errors; without it, the longer side could be one pixel too long.</summary>
    private const double RoundingPixels = 1e-6;

    private readonly RoadCurves _curves;
    private readonly LaneNetwork? _lanes;
    private readonly double _west;
    private readonly double _north;
    private readonly double _pixelsPerMetre;

    /// <summary>Prepares a map.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="area">The part to draw, world, metres, x east and y north; null for all.</param>
    /// <param name="longSidePixels">Length of the longer side, pixels; at least 16.</param>
    /// <param name="lanes">The lanes to draw; null for roads as lines.</param>
    /// <exception cref="ArgumentException">The network has no nodes, or the area is empty.</exception>
    public RoadMap(RoadNetwork network, Box2D? area, int longSidePixels, LaneNetwork? lanes = null)
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
        Size = new ImageSize(PixelsOf(width), PixelsOf(height));
        _lanes = lanes;
    }

    /// <summary>Whether the map shows lanes.</summary>
    public bool ShowsLanes => _lanes is not null;

    /// <summary>Size of the map, pixels.</summary>
    public ImageSize Size { get; }

    /// <summary>Size of a pixel, metres.</summary>
    public double MetresPerPixel => 1 / _pixelsPerMetre;

    /// <summary>Whether any road is in the map.</summary>
    public bool HasRoads => RoadMapStyle.InOrder.Any(style => InPixels(LinesOf(style)).Any());

    /// <summary>What is drawn, in order: if lanes are, only the roads that have none are lines.</summary>
    private IEnumerable<MapLayer> Layers =>
        RoadMapStyle
            .InOrder.Where(style => _lanes is null || style == RoadMapStyle.Water || style == RoadMapStyle.NotDrivable)
            .Select(style => new MapLayer(style.Name, style.Colour, style.Weight * StreetWidthPixels, LinesOf(style)))
            .Concat(_lanes is null ? [] : LaneLayers.Of(_lanes));

    /// <summary>Draws the map as a raster image.</summary>
    public PixelBuffer Draw()
    {
        var picture = new PixelBuffer(Size);
        Array.Fill(picture.Bytes, byte.MaxValue);
        var canvas = new LineCanvas(picture);
        foreach (MapLayer layer in Layers)
        {
            foreach (Vector2D[] line in InPixels(layer.Lines))
            {
                for (int i = 1; i < line.Length; i++)
                {
                    canvas.Line(line[i - 1], line[i], layer.WidthPixels, layer.Colour);
                }
            }
        }

        return picture;
    }

    /// <summary>Writes the map as SVG, with a path for each kind of road and a legend, unless the map is tiny.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteSvg(Stream stream) =>
        SvgImage.Write(
            stream,
            Size.Width,
            Size.Height,
            svg =>
            {
                foreach (MapLayer layer in Layers)
                {
                    svg.Start("path").With("id", IdOf(layer)).With("fill", "none").With("stroke", ColourOf(layer.Colour));
                    svg.With("stroke-width", layer.WidthPixels, WidthDecimals)
                        .With("stroke-linecap", "round")
                        .WithLines(InPixels(layer.Lines))
                        .End()
                        .NewLine();
                }

                if (Math.Min(Size.Width, Size.Height) >= MinSideWithLegend)
                {
                    WriteLegend(svg);
                }
            }
        );

    private static string IdOf(MapLayer layer) => layer.Name.Replace(": ", "-", StringComparison.Ordinal).Replace(' ', '-');

    private void WriteLegend(MarkupWriter svg)
    {
        MapLayer[] layers = [.. Layers];
        const int left = 10;
        const int lineHeight = 16;
        const int sampleLength = 24;
        svg.Start("g").With("id", "legend").With("font-family", "sans-serif").With("font-size", 11).NewLine();
        svg.Start("rect").With("width", 160).With("height", lineHeight * (layers.Length + 1));
        svg.With("fill", "#ffffff").With("fill-opacity", 0.8).End().NewLine();
        foreach ((int index, MapLayer layer) in layers.Reverse().Index())
        {
            int y = lineHeight * (index + 1);
            svg.Start("path").With("stroke", ColourOf(layer.Colour)).With("stroke-width", 3);
            svg.WithLines([
                    [new Vector2D(left, y), new Vector2D(left + sampleLength, y)],
                ])
                .End();
            svg.Start("text").With("x", left + sampleLength + 6).With("y", y + 4).Text(layer.Name).End().NewLine();
        }

        svg.End().NewLine();
    }

    private static string ColourOf(int colour) => string.Create(CultureInfo.InvariantCulture, $"#{colour:x6}");

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

    private int PixelsOf(double metres) => Math.Max(1, (int)Math.Ceiling((metres * _pixelsPerMetre) - RoundingPixels));

    /// <summary>The lines of the roads of a kind, metres, world.</summary>
    private IEnumerable<Vector3D[]> LinesOf(RoadMapStyle style)
    {
        RoadNetwork network = _curves.Network;
        for (int i = 0; i < network.Links.Count; i++)
        {
            if (RoadMapStyle.Of(network, network.Links[i]) == style)
            {
                RoadCurve curve = _curves.Of(i);
                yield return [.. Enumerable.Range(0, Pieces + 1).Select(step => curve.PointAt(step / (double)Pieces))];
            }
        }
    }

    /// <summary>The lines that touch the map, in pixels.</summary>
    private IEnumerable<Vector2D[]> InPixels(IEnumerable<Vector3D[]> lines)
    {
        foreach (Vector2D[] line in lines.Select(line => (Vector2D[])[.. line.Select(Pixel)]))
        {
            if (
                line.Max(point => point.X) >= 0
                && line.Min(point => point.X) <= Size.Width
                && line.Max(point => point.Y) >= 0
                && line.Min(point => point.Y) <= Size.Height
            )
            {
                yield return line;
            }
        }
    }

    private Vector2D Pixel(Vector3D place) => new((place.X - _west) * _pixelsPerMetre, (_north - place.Y) * _pixelsPerMetre);
}
