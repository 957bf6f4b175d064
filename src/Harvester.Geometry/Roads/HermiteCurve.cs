namespace Harvester.Geometry.Roads;

/// <summary>
/// A cubic curve on the ground by its ends and the derivatives there, with the height linear between the ends. Its parameter runs from 0
/// to 1.
/// </summary>
/// <param name="Start">Metres, world.</param>
/// <param name="End">Metres, world.</param>
/// <param name="StartVelocity">Derivative by the parameter at the start, metres.</param>
/// <param name="EndVelocity">Derivative by the parameter at the end, metres.</param>
public readonly record struct HermiteCurve(Vector3D Start, Vector3D End, Vector2D StartVelocity, Vector2D EndVelocity)
{
    /// <summary>Pieces in which the length is computed: of a quarter circle, its relative error is below 1e-6.</summary>
    private const int Pieces = 8;

    /// <summary>Arc length on the ground, metres.</summary>
    public double Length
    {
        get
        {
            double length = 0;
            for (int piece = 0; piece < Pieces; piece++)
            {
                length += LengthBetween(piece / (double)Pieces, (piece + 1) / (double)Pieces);
            }

            return length;
        }
    }

    private Vector2D GroundStart => new(Start.X, Start.Y);

    private Vector2D GroundEnd => new(End.X, End.Y);

    /// <summary>The point at a parameter, metres, world.</summary>
    public Vector3D PointAt(double parameter)
    {
        Vector2D ground = GroundAt(parameter);
        return new Vector3D(ground.X, ground.Y, HeightAt(parameter));
    }

    /// <summary>The derivative on the ground by the parameter, metres.</summary>
    public Vector2D VelocityAt(double parameter)
    {
        double t = parameter;
        double s = 1 - t;
        return ((GroundEnd - GroundStart) * (6 * t * s)) + (StartVelocity * (s * (1 - (3 * t)))) + (EndVelocity * (t * ((3 * t) - 2)));
    }

    /// <summary>A point on the ground beside the curve, at the curve's height, metres, world.</summary>
    /// <param name="parameter">Where along the curve.</param>
    /// <param name="offset">Metres to the right of the curve.</param>
    public Vector3D PointBeside(double parameter, double offset)
    {
        Vector2D velocity = VelocityAt(parameter);
        double scale = velocity.Length > 0 ? offset / velocity.Length : 0;
        Vector3D point = PointAt(parameter);
        return new Vector3D(point.X + (velocity.Y * scale), point.Y - (velocity.X * scale), point.Z);
    }

    /// <summary>A part of the curve, as a curve of its own.</summary>
    /// <param name="from">Parameter where it begins.</param>
    /// <param name="to">Parameter where it ends, greater than <paramref name="from"/>.</param>
    public HermiteCurve Between(double from, double to) =>
        // With u from 0 to 1 for t from a to b, dp/du = (b - a) dp/dt; a part of a cubic is the cubic with these ends and derivatives.
        new(PointAt(from), PointAt(to), VelocityAt(from) * (to - from), VelocityAt(to) * (to - from));

    /// <summary>The same curve from its end to its start.</summary>
    public HermiteCurve Reversed() => new(End, Start, EndVelocity * -1, StartVelocity * -1);

    internal Vector2D GroundAt(double t)
    {
        // Hermite basis with s = 1 - t: s²(1 + 2t), t·s², t²(3 - 2t) and -t²·s.
        double s = 1 - t;
        return (GroundStart * (s * s * (1 + (2 * t))))
            + (StartVelocity * (t * s * s))
            + (GroundEnd * (t * t * (3 - (2 * t))))
            - (EndVelocity * (t * t * s));
    }

    internal double HeightAt(double parameter) => Start.Z + ((End.Z - Start.Z) * parameter);

    /// <summary>The second derivative on the ground by the parameter, metres.</summary>
    internal Vector2D AccelerationAt(double t) =>
        ((GroundEnd - GroundStart) * (6 - (12 * t))) + (StartVelocity * ((6 * t) - 4)) + (EndVelocity * ((6 * t) - 2));

    /// <summary>Arc length between two parameters, by Gauss quadrature with three points, exact up to degree five.</summary>
    internal double LengthBetween(double from, double to)
    {
        double middle = (from + to) / 2;
        double half = (to - from) / 2;
        double outer = half * Math.Sqrt(0.6);
        return half
            * ((5 * VelocityAt(middle - outer).Length) + (8 * VelocityAt(middle).Length) + (5 * VelocityAt(middle + outer).Length))
            / 9;
    }
}
