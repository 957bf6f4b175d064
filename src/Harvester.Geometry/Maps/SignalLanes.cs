namespace Harvester.Geometry.Maps;

/// <summary>
/// Which lanes a traffic light or sign governs: those of the road that it faces at a junction. Lights stand at the stop line or beyond the
/// junction, beside the road or on its axis; signs stand at the stop line. Of several roads, it is the one at whose end it stands nearest
/// and that it faces best.
/// </summary>
public static class SignalLanes
{
    /// <summary>Lights govern junctions where at least this many roads meet.</summary>
    internal const int MinArms = 3;

    /// <summary>No car can wait on a shorter road between junctions, metres; lights then hold back the traffic before it.</summary>
    private const double ShortestToWait = 7;

    /// <summary>Greatest angle between what a light faces and the traffic that comes, radians: 50 degrees.</summary>
    private const double MaxTurn = 0.87;

    /// <summary>Greatest distance before the end of the lanes, metres: a corner and a crossing lie between.</summary>
    private const double MaxBefore = 14;

    /// <summary>Greatest distance of a light beyond the end of the lanes, metres: across a wide junction.</summary>
    private const double MaxAhead = 60;

    /// <summary>Greatest distance of a sign beyond the end of the lanes, metres.</summary>
    private const double MaxAheadOfSign = 10;

    /// <summary>Greatest distance beside the lanes, metres.</summary>
    private const double MaxBeside = 25;

    /// <summary>Roads farther above or below are on another level, metres; a light's place is the foot of its pole or its head.</summary>
    private const double SameLevel = 9;

    /// <summary>How much an angle of a radian counts beside a distance, metres.</summary>
    private const double MetresPerRadian = 25;

    /// <summary>The lanes that a light or sign governs.</summary>
    /// <param name="map">The map.</param>
    /// <param name="position">Where its pole stands, metres, world.</param>
    /// <param name="facing">The direction in which it looks, against the traffic; only its direction on the ground matters.</param>
    /// <param name="kind">What it is.</param>
    /// <returns>The lanes from left to right; empty if it faces no road at a junction near it.</returns>
    public static IReadOnlyList<MapLane> Of(
        LaneNetwork map,
        Vector3D position,
        Vector3D facing,
        MapSignalKind kind = MapSignalKind.Light
    ) => ApproachOf(Guard.NotNull(map, nameof(map)), position, facing, kind)?.Lanes ?? [];

    internal static LaneApproach? ApproachOf(LaneNetwork map, Vector3D position, Vector3D facing, MapSignalKind kind)
    {
        LaneApproach? best = null;
        double least = double.PositiveInfinity;
        foreach (LaneApproach approach in map.ApproachesNear(position, MaxAhead + MaxBeside))
        {
            if (map.ArmsOf(approach.Junction) >= MinArms && CostOf(approach, position, facing, kind) is { } cost && cost < least)
            {
                (best, least) = (approach, cost);
            }
        }

        return best;
    }

    private static double? CostOf(LaneApproach approach, Vector3D position, Vector3D facing, MapSignalKind kind)
    {
        Vector2D against = approach.Direction * -1;
        var looks = new Vector2D(facing.X, facing.Y);
        double turn = Math.Abs(Math.Atan2(against.Cross(looks), against.Dot(looks)));
        Vector3D middle = (approach.Left + approach.Right) * 0.5;
        var to = new Vector2D(position.X - middle.X, position.Y - middle.Y);
        double ahead = to.Dot(approach.Direction);
        double half = new Vector2D(approach.Right.X - approach.Left.X, approach.Right.Y - approach.Left.Y).Length / 2;
        double beside = Math.Max(0, Math.Abs(to.Cross(approach.Direction)) - half);
        bool isPossible =
            turn <= MaxTurn
            && ahead >= -MaxBefore
            && ahead <= (kind == MapSignalKind.Light ? MaxAhead : MaxAheadOfSign)
            && beside <= MaxBeside
            && Math.Abs(position.Z - middle.Z) <= SameLevel
            && approach.IsAtLeast(ShortestToWait);
        return isPossible ? Math.Abs(ahead) + beside + (MetresPerRadian * turn) : null;
    }
}
