using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The lanes of a session's roads, as the map expansion has them.</summary>
internal sealed class NuScenesLanes
{
    private readonly LaneNetwork _map;
    private readonly Dictionary<string, string> _texts;

    /// <summary>Prepares the lanes of a session.</summary>
    public NuScenesLanes(RoadNetwork network, LaneWidths widths)
    {
        _map = LaneNetwork.Of(new RoadCurves(network), new LaneModel(network, widths.Ordinary, widths.Narrow));
        _texts = ExpansionContent.Of(_map).Lanes.ToDictionary(lane => lane.Id, lane => lane.ToString(), StringComparer.Ordinal);
    }

    /// <summary>The lanes that come within a distance of a place, as texts that <see cref="ExpansionLane.Parse"/> reads.</summary>
    public IEnumerable<string> Near(Vector3D place, double range) =>
        _map.Index.Near(place, range).Select(lane => _texts.GetValueOrDefault(lane.Id)).OfType<string>();
}
