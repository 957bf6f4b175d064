using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Events;

/// <summary>A line before a junction of the town that its traffic passes: the end of the lanes, or a painted line.</summary>
/// <param name="Junction">The junction.</param>
/// <param name="Arm">The arm.</param>
/// <param name="HasLight">Whether a light stands there.</param>
/// <param name="HasStopSign">Whether a stop sign does.</param>
/// <param name="At">Its distance from the junction's node along the road, metres.</param>
internal sealed record TownLine(Junction Junction, RoadArm Arm, bool HasLight, bool HasStopSign, double At)
{
    private const double FarthestPaint = 12;

    private readonly Vector3D _place = Arm.Road.Curve.PositionAt(Arm.DistanceAt(At));
    private readonly Vector3D _along = Arm.Road.Curve.TangentAt(Arm.DistanceAt(At)) * (Arm.AtStart ? -1 : 1);

    public double Height => _place.Z;

    /// <summary>Direction of the traffic, radians counter-clockwise from east.</summary>
    public double Bearing => Math.Atan2(_along.Y, _along.X);

    /// <summary>How far a point lies past the line, metres, and how far to the right of the road's line as the traffic sees it.</summary>
    public (double Past, double Right) Of((double X, double Y) point)
    {
        double length = Math.Sqrt((_along.X * _along.X) + (_along.Y * _along.Y));
        (double x, double y) = (_along.X / length, _along.Y / length);
        (double px, double py) = (point.X - _place.X, point.Y - _place.Y);
        return ((px * x) + (py * y), (px * y) - (py * x));
    }

    /// <summary>The line where it is painted, if a painted one lies across the lanes near it.</summary>
    public TownLine MovedTo(IEnumerable<PaintedMark> stopLines)
    {
        double[] past =
        [
            .. stopLines
                .Select(mark => mark.Corners.Select(corner => Of((corner.X, corner.Y))).ToArray())
                .Where(corners => corners.All(corner => IsOnLanes(corner.Right)))
                .Select(corners => corners.Average(corner => corner.Past))
                .Where(middle => Math.Abs(middle) <= FarthestPaint)
                .OrderBy(Math.Abs),
        ];
        return past.Length == 0 ? this : new TownLine(Junction, Arm, HasLight, HasStopSign, At - past[0]);
    }

    /// <summary>Whether a place so far to the right lies on a lane of the arm's traffic.</summary>
    public bool IsOnLanes(double right)
    {
        LaneLayout layout = Arm.Road.Layout;
        bool towards = !Arm.AtStart;
        double offset = towards ? right : -right;
        return Enumerable
            .Range(0, layout.Lanes(towards))
            .Any(lane => Math.Abs(offset - layout.LaneCentre(towards, lane)) <= layout.LaneWidth / 2);
    }
}
