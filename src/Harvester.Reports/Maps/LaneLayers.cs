using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Reports.Maps;

/// <summary>The lanes of a map, the ways through junctions, stop lines, crossings and lights, as lines.</summary>
internal static class LaneLayers
{
    /// <summary>The layers in the order in which they are drawn.</summary>
    public static IEnumerable<MapLayer> Of(LaneNetwork map)
    {
        yield return new MapLayer("crossing", 0xB4B4B4, 1.5, map.Crossings.Select(crossing => Closed(crossing.Corners)));
        foreach (RoadMapStyle style in RoadMapStyle.InOrder)
        {
            yield return new MapLayer(
                $"lanes: {style.Name}",
                style.Colour,
                1,
                map.Segments.Where(road => RoadMapStyle.Of(map.Network, map.Network.Links[road.Link]) == style).SelectMany(EdgesOf)
            );
        }

        yield return new MapLayer(
            "way through a junction",
            0x7846B4,
            1,
            map.Junctions.SelectMany(junction => junction.Ways).Select(Middle)
        );
        yield return new MapLayer("stop line", 0xC80000, 2, map.StopLines.Select(line => new[] { line.Left, line.Right }));
        MapSignal[] lights = [.. map.Signals.Where(signal => signal.Kind == MapSignalKind.Light)];
        yield return new MapLayer("light to its lanes", 0x50A050, 1, lights.SelectMany(LinksOf));
        yield return new MapLayer("light", 0x007800, 4, lights.Select(Mark));
    }

    private static IEnumerable<Vector3D[]> EdgesOf(RoadSegment road) =>
        road
            .Forward.Concat(road.Backward)
            .SelectMany(lane =>
                (Vector3D[][])
                    [
                        [.. lane.Left],
                        [.. lane.Right],
                    ]
            );

    private static Vector3D[] Middle(MapLane way) => [.. way.Centre];

    private static Vector3D[] Closed(IReadOnlyList<Vector3D> corners) => [.. corners, corners[0]];

    private static IEnumerable<Vector3D[]> LinksOf(MapSignal light) =>
        light.Lanes.Select(lane => new[] { light.Position, lane.Centre[^1] });

    /// <summary>A metre in the direction in which a light looks.</summary>
    private static Vector3D[] Mark(MapSignal light) => [light.Position, light.Position + light.Facing];
}
