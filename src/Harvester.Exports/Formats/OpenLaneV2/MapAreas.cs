using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>The pedestrian crossings and the edges of carriageways within the range of a frame.</summary>
internal static class MapAreas
{
    /// <summary>The benchmark's number of a crossing.</summary>
    public const int Crossing = 1;

    /// <summary>The benchmark's number of an edge of the road.</summary>
    public const int Boundary = 2;

    /// <summary>A shorter part of an edge is left out, metres.</summary>
    private const double MinLength = 1;

    /// <summary>The areas, each with its number in the benchmark and its points in the vehicle's frame, metres.</summary>
    /// <param name="map">The map.</param>
    /// <param name="vehicle">The vehicle's frame.</param>
    public static IEnumerable<(int Category, IReadOnlyList<Vector3D> Points)> Of(LaneNetwork map, Pose vehicle)
    {
        foreach (MapCrossing crossing in map.Crossings)
        {
            Vector3D[] outline = VehicleRange.Points([.. crossing.Corners, crossing.Corners[0]], vehicle);
            if (outline.All(point => Math.Abs(point.X) <= VehicleRange.Ahead && Math.Abs(point.Y) <= VehicleRange.Aside))
            {
                yield return (Crossing, outline);
            }
        }

        foreach (Vector3D[] edge in map.Segments.SelectMany(EdgesOf).Select(edge => VehicleRange.Points(edge, vehicle)))
        {
            foreach ((double from, double to) in VehicleRange.Within(edge))
            {
                Vector3D[] part = VehicleRange.Part(edge, from, to);
                if (VehicleRange.LengthOf(part) >= MinLength)
                {
                    yield return (Boundary, part);
                }
            }
        }
    }

    /// <summary>The outer edges of a road: on the right of each direction, and on the left of one that has no lanes beside it.</summary>
    private static IEnumerable<IReadOnlyList<Vector3D>> EdgesOf(RoadSegment road)
    {
        foreach (IReadOnlyList<MapLane> side in (IReadOnlyList<MapLane>[])[road.Forward, road.Backward])
        {
            if (side.Count > 0)
            {
                yield return side[^1].Right;
                if (side[0].Oncoming is null)
                {
                    yield return side[0].Left;
                }
            }
        }
    }
}
