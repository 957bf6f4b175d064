using System.Text.Json;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Datasets.Roads;

/// <summary>The lanes of the roads that a session keeps beside its scenes, with the names that its labels use.</summary>
public static class SessionLanes
{
    /// <summary>Reads the roads of a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="others">The roads to take if the session keeps none: those on which it was harvested; null for none.</param>
    /// <returns>The lanes around any place; null if there are no roads.</returns>
    /// <exception cref="DatasetFormatException">The roads or the settings of the session are invalid; the message names it.</exception>
    public static LaneMaps? Of(SessionReader session, RoadNetwork? others = null)
    {
        ArgumentNullException.ThrowIfNull(session);
        string name = SessionInfo.FileName;
        try
        {
            using JsonDocument document = JsonInput.Read(session.PathOf(name));
            var header = new JsonFields(document.RootElement);
            LaneWidths widths = header.Has("settings")
                ? LaneWidths.Of(header.Fields("settings"))
                : new LaneWidths(RoadGeometry.LaneWidth, RoadGeometry.NarrowLaneWidth);
            name = FramePaths.Roads;
            return (KeptFiles.ReadRoads(session) ?? others) is { } network
                ? new LaneMaps(new RoadCurves(network), new LaneModel(network, widths.Ordinary, widths.Narrow))
                : null;
        }
        catch (Exception e) when (e is DatasetFormatException or JsonException)
        {
            throw new DatasetFormatException($"{session.PathOf(name)}: {JsonFault.InText(e)}", e);
        }
    }
}
