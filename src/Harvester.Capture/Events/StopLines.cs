using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>Knows which stop lines the lights and stop signs around the ego hold traffic back at, and which lights are red.</summary>
/// <param name="lights">The lights whose state is known; null if there are none.</param>
/// <param name="paint">The paint on the roads; null if it is not known.</param>
internal sealed class StopLines(ILights? lights, IRoadPaint? paint)
{
    private readonly Dictionary<int, (string Model, Pose Pose, StopLine? Line, MapSignalKind Kind)> _props = [];
    private Dictionary<string, StopLine> _before = [];
    private LaneNetwork? _map;

    /// <summary>The lines at a reading, which follows those before it.</summary>
    /// <param name="map">The lanes around the ego.</param>
    /// <param name="entities">The entities around it.</param>
    /// <param name="seconds">The game's time, seconds.</param>
    /// <param name="gameFrame">The game's frame count.</param>
    public IReadOnlyList<StopLine> At(LaneNetwork map, IEnumerable<EntityState> entities, double seconds, long gameFrame)
    {
        if (!ReferenceEquals(map, _map))
        {
            _props.Clear();
            _map = map;
        }

        var now = new Dictionary<string, StopLine>(StringComparer.Ordinal);
        var states = new Dictionary<string, (bool IsRed, bool IsOther)>(StringComparer.Ordinal);
        foreach (EntityState entity in entities.Where(static each => each.Class is ObjectClass.TrafficLight or ObjectClass.Sign))
        {
            (StopLine? line, MapSignalKind kind) = LineOf(map, entity);
            if (line is null)
            {
                continue;
            }

            if (!now.TryGetValue(line.Id, out StopLine? known))
            {
                now.Add(line.Id, known = line);
                known.HasStopSign = false;
            }

            known.HasStopSign |= kind == MapSignalKind.StopSign;
            if (kind == MapSignalKind.Light && lights?.SetStateOf(entity.Handle, gameFrame) is { } state && state != LightState.Unknown)
            {
                states.TryGetValue(line.Id, out (bool IsRed, bool IsOther) seen);
                states[line.Id] = (seen.IsRed || state == LightState.Red, seen.IsOther || state != LightState.Red);
            }
        }

        foreach (StopLine line in now.Values)
        {
            bool isRed = states.TryGetValue(line.Id, out (bool IsRed, bool IsOther) state) && state.IsRed && !state.IsOther;
            bool wasSeen = _before.TryGetValue(line.Id, out StopLine? before);
            line.RedSince =
                !isRed || !wasSeen ? null
                : before!.IsRed ? before.RedSince
                : seconds;
            line.IsRed = isRed;
        }

        _before = now;
        return [.. now.Values];
    }

    /// <summary>The line of a light or stop sign; null if it governs none.</summary>
    private (StopLine? Line, MapSignalKind Kind) LineOf(LaneNetwork map, EntityState entity)
    {
        if (_props.TryGetValue(entity.Handle, out var known) && known.Model == entity.Model && known.Pose == entity.Pose)
        {
            return (known.Line, known.Kind);
        }

        StopLine? line = null;
        MapProp? prop = MapProps.Of(entity.Model, entity.Pose);
        if (prop is { Kind: MapSignalKind.Light or MapSignalKind.StopSign })
        {
            IReadOnlyList<MapLane> lanes = SignalLanes.Of(map, prop.Position, prop.Facing, prop.Kind);
            line = lanes.Count > 0 ? Known(lanes[0].Id) ?? Placed(StopLine.AtEndOf(lanes)) : null;
        }

        _props[entity.Handle] = (entity.Model, entity.Pose, line, prop?.Kind ?? MapSignalKind.GiveWay);
        return (line, prop?.Kind ?? MapSignalKind.GiveWay);
    }

    /// <summary>The line, if another light of the same road has it already.</summary>
    private StopLine? Known(string id) => _props.Values.Select(static each => each.Line).FirstOrDefault(each => each?.Id == id);

    /// <summary>The line where it is painted, as far as that is known.</summary>
    private StopLine Placed(StopLine line) => paint is null ? line : line.MovedTo(paint.StopLinesNear(line.Middle, StopLine.MaxMove));
}
