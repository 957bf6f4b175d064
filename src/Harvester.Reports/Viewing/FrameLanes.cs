using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Reports.Viewing;

/// <summary>Writes the lanes of the map around the ego for the bird's-eye view, and which of them are the ego's and ahead of it.</summary>
internal static class FrameLanes
{
    /// <summary>How far from the ego a lane may be, metres: as far as the view reaches.</summary>
    private const double Range = 90;

    private const int Decimals = 1;

    /// <summary>Writes the lanes as "map".</summary>
    public static void Write(Utf8JsonWriter json, FrameLabel label, LaneMaps maps)
    {
        HashSet<string> ahead = [.. label.Lanes?.LanesAhead ?? []];
        json.WriteStartArray("map");
        foreach (MapLane lane in maps.Around(label.Ego.Position)?.Index.Near(label.Ego.Position, Range) ?? [])
        {
            json.WriteStartObject();
            json.WriteString("id", lane.Id);
            json.WriteString(
                "role",
                lane.Id == label.Lanes?.LaneId ? "own"
                    : ahead.Contains(lane.Id) ? "ahead"
                    : lane.Junction is null ? "lane"
                    : "way"
            );
            json.Numbers("left", Ground(lane.Left), Decimals);
            json.Numbers("right", Ground(lane.Right), Decimals);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static double[] Ground(IReadOnlyList<Vector3D> points) => [.. points.SelectMany(point => new[] { point.X, point.Y })];
}
