using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as JSON of the nuScenes map expansion, version 1.3. Names of lanes are their tokens. Coordinates are metres east and
/// north of a corner of the map.
/// </summary>
public static class NuScenesExpansion
{
    /// <summary>What the map reaches beyond its lanes, metres.</summary>
    private const double Margin = 20;

    /// <summary>The names of maps that nuScenes' reader accepts.</summary>
    internal static IReadOnlyList<string> Names { get; } =
    ["singapore-onenorth", "singapore-hollandvillage", "singapore-queenstown", "boston-seaport"];

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map; it has at least one lane.</param>
    /// <param name="stream">Receives the file, UTF-8.</param>
    public static void Write(LaneNetwork map, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        ArgumentNullException.ThrowIfNull(stream);
        var content = ExpansionContent.Of(map);
        double west = double.PositiveInfinity;
        double south = double.PositiveInfinity;
        double east = double.NegativeInfinity;
        double north = double.NegativeInfinity;
        foreach (Vector2D point in content.Lanes.SelectMany(lane => lane.Left.Concat(lane.Right)))
        {
            (west, south) = (Math.Min(west, point.X), Math.Min(south, point.Y));
            (east, north) = (Math.Max(east, point.X), Math.Max(north, point.Y));
        }

        var corner = new Vector2D(Math.Floor(west - Margin), Math.Floor(south - Margin));
        var size = new Vector2D(Math.Ceiling(east + Margin) - corner.X, Math.Ceiling(north + Margin) - corner.Y);
        new ExpansionLayers(content, corner * -1, size).Write(stream);
    }
}
