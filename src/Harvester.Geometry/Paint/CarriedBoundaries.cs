using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Completes the boundaries of links from others of the same road: those that continue it without a junction, with the same lanes.
/// </summary>
internal sealed class CarriedBoundaries
{
    /// <summary>How far along a road a boundary is taken for unchanged, metres.</summary>
    private const double MaxDistance = 150;

    /// <summary>Boundaries of two links that both have measured agree within this distance, metres, or the road has changed.</summary>
    private const double MaxDifference = 0.25;

    private readonly RoadNetwork _network;
    private readonly RoadContinuations _continuations;
    private readonly int[] _linksAt;
    private readonly IReadOnlyDictionary<(int Link, bool IsForward), double?[]> _measured;

    public CarriedBoundaries(RoadNetwork network, IReadOnlyDictionary<(int Link, bool IsForward), double?[]> measured)
    {
        _network = network;
        _continuations = new RoadContinuations(network);
        _measured = measured;
        _linksAt = new int[network.Nodes.Count];
        foreach (RoadLink link in network.Links)
        {
            _linksAt[link.From]++;
            _linksAt[link.To]++;
        }
    }

    /// <summary>The boundaries of a direction of a link, and whether lines on this link confirm them.</summary>
    public (double?[] Boundaries, bool IsConfirmed) Of(int link, bool isForward)
    {
        RoadLink road = _network.Links[link];
        double?[] own = _measured.TryGetValue((link, isForward), out double?[]? measured)
            ? (double?[])measured.Clone()
            : new double?[(isForward ? road.LanesForward : road.LanesBackward) + 1];
        bool isConfirmed = measured is not null;
        if (Array.TrueForAll(own, static offset => offset is not null))
        {
            return (own, isConfirmed);
        }

        foreach (
            double?[] other in Others(link, isForward, ahead: true)
                .Concat(Others(link, isForward, ahead: false))
                .OrderBy(static other => other.Distance)
                .Select(static other => other.Boundaries)
        )
        {
            double[] differences = [.. own.Zip(other, static (a, b) => Math.Abs(a - b ?? double.NaN)).Where(static d => !double.IsNaN(d))];
            if (differences.Length > 0 && differences.Max() > MaxDifference)
            {
                break;
            }

            for (int i = 0; i < own.Length; i++)
            {
                own[i] ??= other[i];
            }
        }

        return (own, isConfirmed);
    }

    /// <summary>The measured links along the road in one direction, with their distances, metres.</summary>
    private IEnumerable<(double Distance, double?[] Boundaries)> Others(int link, bool isForward, bool ahead)
    {
        double distance = 0;
        int at = link;
        bool along = isForward;
        while (distance <= MaxDistance)
        {
            RoadLink road = _network.Links[at];
            int node = along == ahead ? road.To : road.From;
            int next = _continuations.Of(at, beyondEnd: along == ahead);
            if (next == RoadContinuations.None || next == link || _linksAt[node] != 2)
            {
                yield break;
            }

            bool nextAlong = (_network.Links[next].From == node) == ahead;
            if (!HasSameLanes(road, along, _network.Links[next], nextAlong))
            {
                yield break;
            }

            (at, along) = (next, nextAlong);
            if (_measured.TryGetValue((at, along), out double?[]? boundaries))
            {
                yield return (distance, boundaries);
            }

            RoadLink passed = _network.Links[at];
            distance += (_network.Nodes[passed.To].Position - _network.Nodes[passed.From].Position).Length;
        }
    }

    private static bool HasSameLanes(RoadLink one, bool oneForward, RoadLink other, bool otherForward)
    {
        RoadLink a = oneForward ? one : one.Reversed();
        RoadLink b = otherForward ? other : other.Reversed();
        return (a.LanesForward, a.LanesBackward, a.MedianWidth, a.Flags) == (b.LanesForward, b.LanesBackward, b.MedianWidth, b.Flags);
    }
}
