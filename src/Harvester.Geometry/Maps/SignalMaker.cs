namespace Harvester.Geometry.Maps;

/// <summary>Makes the signals of a map from props; of several at one place, the first.</summary>
internal static class SignalMaker
{
    public static List<MapSignal> Make(LaneNetwork map, IEnumerable<MapProp> props)
    {
        var signals = new List<MapSignal>();
        var names = new HashSet<string>(StringComparer.Ordinal);
        foreach (MapProp prop in props)
        {
            string id = MapNames.Place(Prefix(prop.Kind), prop.Position);
            double length = new Vector2D(prop.Facing.X, prop.Facing.Y).Length;
            if (length > 0 && names.Add(id))
            {
                LaneApproach? approach = SignalLanes.ApproachOf(map, prop.Position, prop.Facing, prop.Kind);
                signals.Add(
                    new MapSignal(
                        id,
                        prop.Kind,
                        prop.Position,
                        new Vector3D(prop.Facing.X / length, prop.Facing.Y / length, 0),
                        prop.Model,
                        approach?.Lanes ?? []
                    )
                );
                foreach (MapLane lane in approach?.Lanes ?? [])
                {
                    lane.Add(signals[signals.Count - 1]);
                }
            }
        }

        return signals;
    }

    private static string Prefix(MapSignalKind kind) =>
        kind switch
        {
            MapSignalKind.Light => "light",
            MapSignalKind.StopSign => "stop",
            _ => "giveway",
        };
}
