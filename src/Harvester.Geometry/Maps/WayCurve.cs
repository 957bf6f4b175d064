using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>The middle of a way through a junction: a cubic curve from the end of one lane to the start of another.</summary>
internal static class WayCurve
{
    /// <summary>
    /// The least radius that the middle of the rear axle of a car drives, metres: with a turning circle of 10.6 m, kerb to kerb, a
    /// wheelbase of 2.7 m and a track of 1.5 m, √(5.3² - 2.7²) - 0.75.
    /// </summary>
    public const double CarRadius = 3.8;

    /// <summary>Lengths of end tangents that are tried where a way is too tight, as fractions of its chord.</summary>
    private const double MinTangent = 0.3;
    private const double GreatestTangent = 2.7;
    private const double TangentStep = 0.15;

    /// <summary>Pieces of a curve at whose ends the radius is looked at.</summary>
    private const int RadiusPieces = 20;

    public static HermiteCurve Of(MapLane from, MapLane to)
    {
        Vector3D start = from.Centre[from.Centre.Count - 1];
        Vector3D end = to.Centre[0];
        Vector2D leaving = from.EndDirection;
        Vector2D arriving = to.StartDirection;

        // With end tangents of this length, the cubic best follows a circle through both ends: 2 chord / (1 + cos(bend / 2)).
        double bend = Math.Abs(Math.Atan2(leaving.Cross(arriving), leaving.Dot(arriving)));
        double chord = new Vector2D(end.X - start.X, end.Y - start.Y).Length;
        double length = 2 * chord / (1 + Math.Cos(bend / 2));
        var widest = new HermiteCurve(start, end, leaving * length, arriving * length);
        double radius = LeastRadius(widest);
        if (radius < CarRadius)
        {
            // Where the ends lie unevenly before and behind the bend: the pair of lengths with the widest bend.
            for (double first = MinTangent; first <= GreatestTangent; first += TangentStep)
            {
                for (double last = MinTangent; last <= GreatestTangent; last += TangentStep)
                {
                    var curve = new HermiteCurve(start, end, leaving * (first * chord), arriving * (last * chord));
                    double its = LeastRadius(curve);
                    (widest, radius) = its > radius ? (curve, its) : (widest, radius);
                }
            }
        }

        return widest;
    }

    /// <summary>The least radius of a curve on the ground, metres.</summary>
    internal static double LeastRadius(HermiteCurve curve)
    {
        double greatest = 0;
        for (int i = 0; i <= RadiusPieces; i++)
        {
            double t = (double)i / RadiusPieces;

            // The curvature |p' × p''| / |p'|³.
            Vector2D velocity = curve.VelocityAt(t);
            double speed = velocity.Length;
            double cross = Math.Abs(velocity.Cross(curve.AccelerationAt(t)));
            greatest = Math.Max(greatest, speed > 0 ? cross / (speed * speed * speed) : double.PositiveInfinity);
        }

        return greatest > 0 ? 1 / greatest : double.PositiveInfinity;
    }
}
