using Harvester.Geometry.Maps;

namespace Harvester.Driving.Scenarios;

/// <summary>Lanes one after another, and the track along them.</summary>
/// <param name="Track">The track.</param>
/// <param name="Lanes">The lanes in the order of driving.</param>
/// <param name="Starts">Where each begins on the track, metres.</param>
internal sealed record LaneChain(LaneTrack Track, IReadOnlyList<MapLane> Lanes, IReadOnlyList<double> Starts)
{
    /// <summary>The lane at a distance; the first before the start and the last past the end.</summary>
    public MapLane LaneAt(double at)
    {
        int i = Lanes.Count - 1;
        while (i > 0 && Starts[i] > at)
        {
            i--;
        }

        return Lanes[i];
    }
}
