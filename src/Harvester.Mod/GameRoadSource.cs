using Harvester.Capture.Ports;
using Harvester.Capture.Roads;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>The game's road nodes, by its natives.</summary>
internal sealed class GameRoadSource : IRoadSource
{
    /// <inheritdoc/>
    public bool RequestNodes(Vector3D centre, double range) => Natives.RequestRoadNodes(centre, range);

    /// <inheritdoc/>
    public SurveyedNode? NthClosestNode(Vector3D place, int number) => Natives.NthClosestRoadNode(place, number);

    /// <inheritdoc/>
    public SurveyedProperties? ReadProperties(Vector3D place) => Natives.RoadNodeProperties(place);

    /// <inheritdoc/>
    public SurveyedRoad? ClosestRoad(Vector3D place) => Natives.ClosestRoad(place);
}
