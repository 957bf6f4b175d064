using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>What a driver sees before it changes lanes: the lanes beside its own, and the gaps in them.</summary>
internal sealed class LaneTravel(LaneGraph lanes)
{
    /// <summary>Minimum gap to a vehicle of equal speed, metres, and the time by which a difference in speed counts, seconds.</summary>
    private const double MinGap = 7;
    private const double SecondsAhead = 1.2;
    private const double SecondsBehind = 2;

    private readonly Dictionary<(Road, bool, int), LanePath> _paths = lanes
        .Paths.Where(path => path.Road is not null)
        .ToDictionary(path => (path.Road!, path.IsForward, path.Lane));

    /// <summary>The lane of the same direction beside another; null if there is none.</summary>
    /// <param name="path">The lane.</param>
    /// <param name="right">1 for the lane on its right, -1 for that on its left.</param>
    public LanePath? Beside(LanePath path, int right) =>
        path.Road is null ? null : _paths.GetValueOrDefault((path.Road, path.IsForward, path.Lane + right));

    /// <summary>Whether a vehicle can move into a lane without making others brake.</summary>
    public static bool HasGap(Vehicle vehicle, LanePath lane, LaneOccupation occupation)
    {
        double own = LanePlace.Of(lane, vehicle.Pose.Position, vehicle.Distance).Distance;
        return occupation.On(lane).All(other => other == vehicle || IsClear(vehicle, own, other, lane))
            && lane.Previous.All(before =>
                occupation.On(before).All(other => other == vehicle || IsClear(vehicle, own + before.Length, other, before))
            );
    }

    private static bool IsClear(Vehicle vehicle, double own, Vehicle other, LanePath lane)
    {
        double ahead = other.DistanceOn(lane) - own;
        double speed = other.SpeedOn(lane);
        return ahead >= 0
            ? ahead - other.RearOverhang - vehicle.FrontOverhang > MinGap + (SecondsAhead * System.Math.Max(0, vehicle.Speed - speed))
            : -ahead - other.FrontOverhang - vehicle.RearOverhang > MinGap + (SecondsBehind * System.Math.Max(0, speed - vehicle.Speed));
    }
}
