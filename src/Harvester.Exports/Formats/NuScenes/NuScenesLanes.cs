using System.Globalization;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// The lanes of a session's roads as the map expansion has them, with their stop lines and crossings, and with the lights and signs of
/// labels. They are made for the squares around the vehicle, which have what the whole network has there.
/// </summary>
internal sealed class NuScenesLanes(RoadNetwork network, LaneWidths widths)
{
    private readonly LaneMaps _maps = new(new RoadCurves(network), new LaneModel(network, widths.Ordinary, widths.Narrow));
    private (LaneNetwork Map, ExpansionContent Content)? _last;

    /// <summary>
    /// The lanes, stop lines and crossings within a distance of a place, as texts that the records of the map read; null if more roads meet
    /// there than a map takes.
    /// </summary>
    /// <param name="place">The vehicle, metres, world.</param>
    /// <param name="range">Metres, at most <see cref="LaneMaps.ReachMetres"/>.</param>
    public IEnumerable<string>? Near(Vector3D place, double range)
    {
        if (_maps.Around(place) is not { } map)
        {
            return null;
        }

        if (_last is not { } made || made.Map != map)
        {
            _last = made = (map, ExpansionContent.Of(map));
        }

        HashSet<string> near = map.Index.Near(place, range).Select(lane => lane.Id).ToHashSet(StringComparer.Ordinal);
        ExpansionLane[] lanes = [.. made.Content.Lanes.Where(lane => near.Contains(lane.Id))];
        HashSet<string> roads = lanes.Select(lane => lane.Road).ToHashSet(StringComparer.Ordinal);
        return
        [
            .. lanes.Select(lane => lane.ToString()),
            .. made.Content.StopLines.Where(line => line.Lanes.All(near.Contains)).Select(line => line.ToString()),
            .. made.Content.Crossings.Where(crossing => roads.Contains(crossing.Road)).Select(crossing => crossing.ToString()),
        ];
    }

    /// <summary>The lights and signs among the objects of a frame, with the stop lines of their lanes, as texts.</summary>
    /// <param name="objects">The objects.</param>
    public IEnumerable<string> Signals(IEnumerable<ObjectLabel> objects) =>
        objects.Where(label => label.Parent is null && label.GovernedLanes is [_, ..]).SelectMany(SignalOf);

    /// <summary>The light or sign of a label, and the stop line of its lanes if the road data has none.</summary>
    private IEnumerable<string> SignalOf(ObjectLabel label)
    {
        if (
            MapProps.Of(label.Model, new Pose(label.Box3D.Centre, label.Box3D.Axes)) is not { } prop
            || _maps.Around(prop.Position) is not { } map
        )
        {
            yield break;
        }

        MapLane[] lanes = [.. label.GovernedLanes!.Select(map.Find).OfType<MapLane>()];
        if (lanes.Length == 0)
        {
            yield break;
        }

        string[] names = [.. lanes.Select(lane => lane.Id)];
        yield return new ExpansionSignal(
            $"{prop.Kind}:{label.Id.ToString(CultureInfo.InvariantCulture)}",
            prop.Kind,
            prop.Position,
            new Vector2D(prop.Facing.X, prop.Facing.Y),
            names
        ).ToString();
        if (Array.TrueForAll(lanes, lane => lane.StopLine is null))
        {
            yield return ExpansionStopLine.At(names[0] + "/stop", lanes).ToString();
        }
    }
}
