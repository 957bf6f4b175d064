using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>Checks that the lanes that labels name are on the map of the session's roads, near what is on them.</summary>
/// <param name="session">The session; if it keeps no roads that can be read, nothing is found.</param>
internal sealed class LaneIdCheck(SessionReader session)
{
    private readonly Lazy<LaneMaps?> _maps = new(() => MapsOf(session));

    /// <summary>What is wrong with the names in a label.</summary>
    public IEnumerable<string> Problems(FrameLabel label)
    {
        if (label.Lanes?.LanesAhead is { } ahead)
        {
            if (label.Lanes.LaneId is null && ahead.Count > 0)
            {
                yield return "lanes.lanesAhead has lanes, but lanes.laneId is null.";
            }

            foreach (string id in Missing(label.Lanes.LaneId is { } own ? ahead.Prepend(own) : ahead, label.Ego.Position))
            {
                yield return $"lanes name the lane '{id}', which the session's roads do not have near the car.";
            }
        }

        foreach (ObjectLabel item in label.Objects)
        {
            IEnumerable<string> ids = item.LaneId is { } lane ? [lane] : item.GovernedLanes ?? [];
            foreach (string id in Missing(ids, item.Box3D.Centre))
            {
                yield return $"object {item.Id} names the lane '{id}', which the session's roads do not have near it.";
            }
        }
    }

    private IEnumerable<string> Missing(IEnumerable<string> ids, Vector3D place) =>
        _maps.Value?.Around(place) is { } map ? ids.Where(id => map.Find(id) is null) : [];

    private static LaneMaps? MapsOf(SessionReader session)
    {
        try
        {
            return SessionLanes.Of(session);
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            // Another check reports files that cannot be read.
            return null;
        }
    }
}
