using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>The part of a lane within the range of a frame, in the vehicle's frame, metres.</summary>
/// <param name="Lane">The lane.</param>
/// <param name="Number">Number of the part, from 0; a lane that leaves the range and comes back has several.</param>
/// <param name="HasStart">Whether the lane begins in the range.</param>
/// <param name="HasEnd">Whether it ends there.</param>
/// <param name="Centre">Points of its middle.</param>
/// <param name="Left">Points of its left edge, beside those of the middle.</param>
/// <param name="Right">Points of its right edge.</param>
internal sealed record ClippedLane(
    MapLane Lane,
    int Number,
    bool HasStart,
    bool HasEnd,
    IReadOnlyList<Vector3D> Centre,
    IReadOnlyList<Vector3D> Left,
    IReadOnlyList<Vector3D> Right
)
{
    /// <summary>Number of lanes in a direction of a road, and of parts of a lane, that have ids of their own.</summary>
    private const int Lanes = 64;
    private const int Parts = 8;

    /// <summary>Number of lanes of a network that ids tell apart: two of them, a direction and a part fit into the 53 bits of a
    /// number.</summary>
    private const long Numbers = 1 << 24;

    /// <summary>A shorter part is left out, metres.</summary>
    private const double MinLength = 0.05;

    /// <summary>A number for the lane that is the same in all frames of a session.</summary>
    public long Id =>
        (Parts * (Lane.Junction is null ? NumberOf(Lane) : (Numbers * (1 + NumberOf(Lane.Predecessors[0]))) + NumberOf(Lane.Successors[0])))
        + Math.Min(Number, Parts - 1);

    /// <summary>The parts of a lane within a range.</summary>
    /// <param name="lane">The lane.</param>
    /// <param name="vehicle">The vehicle's frame, with axes right, forward and up.</param>
    public static IEnumerable<ClippedLane> Of(MapLane lane, Pose vehicle)
    {
        Vector3D[] centre = VehicleRange.Points(lane.Centre, vehicle);
        Vector3D[] left = VehicleRange.Points(lane.Left, vehicle);
        Vector3D[] right = VehicleRange.Points(lane.Right, vehicle);
        int number = 0;
        foreach ((double from, double to) in VehicleRange.Within(centre))
        {
            Vector3D[] middle = VehicleRange.Part(centre, from, to);
            if (VehicleRange.LengthOf(middle) >= MinLength)
            {
                yield return new ClippedLane(
                    lane,
                    number++,
                    from == 0,
                    to == centre.Length - 1,
                    middle,
                    VehicleRange.Part(left, from, to),
                    VehicleRange.Part(right, from, to)
                );
            }
        }
    }

    /// <summary>Whether the lane leads from one part to another.</summary>
    public bool LeadsTo(ClippedLane next) => HasEnd && next.HasStart && Lane.Successors.Contains(next.Lane);

    private static long NumberOf(MapLane lane) =>
        ((lane.Link!.Value * 2L) + (lane.IsForward ? 0 : 1)) * Lanes % Numbers + Math.Min(lane.Index, Lanes - 1);
}
