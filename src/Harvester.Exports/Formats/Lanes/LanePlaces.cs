using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// Numbers the two nearest lines on each side of the car: 1 left-left, 2 left, 3 right, 4 right-right; others are 0. OpenLane and CULane
/// number them so.
/// </summary>
internal static class LanePlaces
{
    /// <summary>Number of numbered lines.</summary>
    public const int Count = 4;

    /// <summary>The numbers, by the index of the line.</summary>
    public static IReadOnlyDictionary<int, int> Of(IReadOnlyList<LaneLineView> lines)
    {
        int[] left = [.. lines.Where(view => view.IsLeftOfCar).Select(view => view.Index).Distinct().OrderDescending()];
        int[] right = [.. lines.Where(view => !view.IsLeftOfCar).Select(view => view.Index).Distinct().Order()];
        return lines
            .Select(view => view.Index)
            .Distinct()
            .ToDictionary(
                index => index,
                index =>
                    Array.IndexOf(left, index) switch
                    {
                        0 => 2,
                        1 => 1,
                        _ => Array.IndexOf(right, index) switch
                        {
                            0 => 3,
                            1 => 4,
                            _ => 0,
                        },
                    }
            );
    }
}
