using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>The lights, signs and stop lines of a Lanelet2 map, and the rules that follow from them.</summary>
internal sealed class Lanelet2Signals
{
    /// <summary>Half the width of the line that stands for a light or sign, metres: its size is unknown.</summary>
    private const double HalfWidth = 0.3;

    private const string Refers = "refers";
    private const string RefLine = "ref_line";
    private const string Yield = "yield";

    private readonly LaneBorders _borders;
    private readonly Dictionary<MapStopLine, Lanelet2Way> _stopLines = [];
    private readonly Dictionary<MapSignal, Lanelet2Way> _signals = [];
    private readonly List<Lanelet2Rule> _rules = [];

    public Lanelet2Signals(LaneNetwork map, LaneBorders borders)
    {
        _borders = borders;
        foreach (MapStopLine line in map.StopLines)
        {
            // A derived line is not painted.
            (string, string)[] tags =
                line.Source == MapSource.Derived ? [("type", "virtual")] : [("type", "stop_line"), ("subtype", "solid")];
            _stopLines.Add(line, Line(line.Left, line.Right, tags));
        }

        foreach (MapSignal signal in map.Signals)
        {
            // Traffic looks against the facing; its right is (d.y, -d.x) of its direction d.
            var right = new Vector3D(-signal.Facing.Y, signal.Facing.X, 0);
            _signals.Add(signal, Line(signal.Position - (right * HalfWidth), signal.Position + (right * HalfWidth), TagsOf(signal)));
        }

        AddLights(map);
        foreach (
            IGrouping<int, MapLane> approach in map
                .Lanes.Where(lane => lane.Junction is null)
                .GroupBy(lane => lane.Successors.Count > 0 ? lane.Successors[0].Junction ?? -1 : -1)
                .Where(group => group.Key >= 0)
        )
        {
            AddSigns([.. approach]);
        }
    }

    /// <summary>The lines of the lights, signs and stop lines.</summary>
    public IEnumerable<Lanelet2Way> Ways => _stopLines.Values.Concat(_signals.Values);

    /// <summary>The rules.</summary>
    public IReadOnlyList<Lanelet2Rule> Rules => _rules;

    private Lanelet2Way Line(Vector3D left, Vector3D right, (string, string)[] tags) =>
        new([_borders.AddNode(left), _borders.AddNode(right)], tags);

    private static (string, string)[] TagsOf(MapSignal signal) =>
        signal.Kind switch
        {
            MapSignalKind.Light => [("type", "traffic_light"), ("subtype", "red_yellow_green")],
            MapSignalKind.StopSign => [("type", "traffic_sign"), ("subtype", "usR1-1")],
            _ => [("type", "traffic_sign"), ("subtype", "usR1-2")],
        };

    /// <summary>A rule for all lights of the same lanes.</summary>
    private void AddLights(LaneNetwork map)
    {
        IEnumerable<IGrouping<string, MapSignal>> groups = map
            .Signals.Where(signal => signal.Kind == MapSignalKind.Light && signal.Lanes.Count > 0)
            .GroupBy(signal => string.Join('|', signal.Lanes.Select(lane => lane.Id)), StringComparer.Ordinal);
        foreach (IGrouping<string, MapSignal> lights in groups)
        {
            IReadOnlyList<MapLane> lanes = lights.First().Lanes;
            _rules.Add(
                new Lanelet2Rule(
                    "traffic_light",
                    [
                        .. lights.Select(light => (_signals[light], Refers)),
                        .. lanes.Select(lane => lane.StopLine).OfType<MapStopLine>().Distinct().Select(line => (_stopLines[line], RefLine)),
                    ],
                    [],
                    lanes
                )
            );
        }
    }

    /// <summary>
    /// The lanes with signs give way to the lanes into the same junction that have neither sign nor light. If there are none and all
    /// have stop signs, everyone stops.
    /// </summary>
    private void AddSigns(MapLane[] approaching)
    {
        MapLane[] yielding = [.. approaching.Where(lane => lane.Signals.Any(signal => signal.Kind != MapSignalKind.Light))];
        MapLane[] first = [.. approaching.Where(lane => lane.Signals.Count == 0)];
        (Lanelet2Way, string)[] signs =
        [
            .. yielding
                .SelectMany(lane => lane.Signals)
                .Where(signal => signal.Kind != MapSignalKind.Light)
                .Distinct()
                .Select(sign => (_signals[sign], Refers)),
        ];
        MapStopLine[] lines = [.. yielding.Select(lane => lane.StopLine).OfType<MapStopLine>()];
        if (yielding.Length > 0 && first.Length > 0)
        {
            _rules.Add(
                new Lanelet2Rule(
                    "right_of_way",
                    [.. signs, .. lines.Distinct().Select(line => (_stopLines[line], RefLine))],
                    [.. first.Select(lane => (lane, "right_of_way")), .. yielding.Select(lane => (lane, Yield))],
                    [.. first, .. yielding]
                )
            );
        }
        else if (
            yielding.Length > 0
            && yielding.Length == approaching.Length
            && Array.TrueForAll(yielding, lane => lane.Signals.Any(signal => signal.Kind == MapSignalKind.StopSign))
        )
        {
            // Lanelet2 requires a stop line for each lanelet or none at all.
            _rules.Add(
                new Lanelet2Rule(
                    "all_way_stop",
                    [.. signs, .. lines.Length == yielding.Length ? lines.Select(line => (_stopLines[line], RefLine)) : []],
                    [.. yielding.Select(lane => (lane, Yield))],
                    yielding
                )
            );
        }
    }
}
