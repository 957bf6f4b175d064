using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Mod;

/// <summary>The piece of road that the game finds closest to a point, as a network of one link.</summary>
internal static class GameRoad
{
    /// <summary>Reads it; null when there is none near.</summary>
    public static RoadNetwork? ClosestTo(Vector3D place) =>
        Natives.ClosestRoad(place) is { } road && (road.End - road.Start).Length > 0
            ? new RoadNetwork(
                [NodeAt(road.Start, 0), NodeAt(road.End, 1)],
                [new RoadLink(0, 1, road.LanesForward, road.LanesBackward, road.MedianWidth, RoadLinkFlags.None)])
            : null;

    private static RoadNode NodeAt(Vector3D place, int number) => new(0, number, place, string.Empty, RoadNodeFlags.None);
}
