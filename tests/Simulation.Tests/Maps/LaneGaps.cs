using Harvester.Geometry.Maps;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>How well lanes that follow each other meet.</summary>
internal static class LaneGaps
{
    /// <summary>What is allowed between the ends of lanes, metres.</summary>
    private const double MaxGap = 0.01;

    /// <summary>What is allowed between their directions, radians.</summary>
    private const double MaxBend = 0.01;

    /// <summary>The number of successors that begin aside or in another direction, of those of all lanes.</summary>
    public static (int Aside, int Bent) Of(LaneNetwork map, ITestOutputHelper output)
    {
        (MapLane From, MapLane To)[] pairs = [.. from lane in map.Lanes from next in lane.Successors select (lane, next)];
        double[] gaps =
        [
            .. pairs.Select(pair =>
                Math.Max(
                    (pair.From.Left[^1] - pair.To.Left[0]).Length,
                    Math.Max((pair.From.Centre[^1] - pair.To.Centre[0]).Length, (pair.From.Right[^1] - pair.To.Right[0]).Length)
                )
            ),
        ];
        double[] bends =
        [
            .. pairs.Select(pair =>
                Math.Abs(
                    Math.Atan2(pair.From.EndDirection.Cross(pair.To.StartDirection), pair.From.EndDirection.Dot(pair.To.StartDirection))
                )
            ),
        ];
        (int aside, int bent) = (gaps.Count(gap => gap > MaxGap), bends.Count(bend => bend > MaxBend));
        output.WriteLine(
            $"{pairs.Length} successors: {aside} begin more than 1 cm aside (at most {gaps.Max():0.000} m), {bent} bend by more than 0.01 "
                + $"(at most {bends.Max():0.0000} rad); {map.Lanes.Count(lane => lane.Successors.Count == 0)} lanes end, "
                + $"{map.Lanes.Count(lane => lane.Predecessors.Count == 0)} begin"
        );
        return (aside, bent);
    }
}
