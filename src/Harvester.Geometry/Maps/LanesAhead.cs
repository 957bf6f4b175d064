namespace Harvester.Geometry.Maps;

/// <summary>Follows lanes to those that continue them.</summary>
public static class LanesAhead
{
    /// <summary>The lanes that can be reached from a place on a lane without turning back or changing lanes.</summary>
    /// <param name="from">The lane.</param>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">How far ahead of the place a lane may begin, metres.</param>
    /// <returns>The lanes and ways, the nearest first, without the lane itself.</returns>
    public static IReadOnlyList<MapLane> From(MapLane from, Vector3D place, double range)
    {
        Guard.NotNull(from, nameof(from));
        var begins = new Dictionary<MapLane, double>();
        var found = new List<MapLane>();
        var open = new SortedSet<(double Metres, string Id)>(
            Comparer<(double Metres, string Id)>.Create(
                static (a, b) => a.Metres != b.Metres ? a.Metres.CompareTo(b.Metres) : string.CompareOrdinal(a.Id, b.Id)
            )
        );
        var lanes = new Dictionary<string, MapLane>(StringComparer.Ordinal);
        Reach(from, from.Length - LanePiece.NearestOf(from, place).Along);
        while (open.Count > 0)
        {
            (double metres, string id) = open.Min;
            open.Remove(open.Min);
            MapLane lane = lanes[id];
            if (begins[lane] == metres)
            {
                found.Add(lane);
                Reach(lane, metres + lane.Length);
            }
        }

        return found;

        void Reach(MapLane lane, double end)
        {
            foreach (MapLane next in lane.Successors.Where(next => next != from && end <= range))
            {
                if (!begins.TryGetValue(next, out double before) || end < before)
                {
                    begins[next] = end;
                    lanes[next.Id] = next;
                    open.Add((end, next.Id));
                }
            }
        }
    }
}
