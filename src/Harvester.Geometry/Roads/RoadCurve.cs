namespace Harvester.Geometry.Roads;

/// <summary>
/// The centre line of one link: a cubic Hermite curve on the ground from its start to its end, with the height interpolated linearly
/// between the two nodes. Its parameter runs from 0 to 1; stations are arc lengths on the ground, metres from the start.
/// </summary>
public sealed class RoadCurve
{
    /// <summary>Number of pieces in which the arc length is tabulated.</summary>
    private const int Pieces = 8;

    /// <summary>Newton steps after which the closest point moves by less than a millimetre on links of the game.</summary>
    private const int NewtonSteps = 5;

    /// <summary>Relative error bound of the numerical arc length and of the point in its middle.</summary>
    private const double ArcTolerance = 0.01;

    /// <summary>A Newton step of the parameter below this ends the search: 0.1 µm on a link of 100 m.</summary>
    private const double MinStep = 1e-9;

    private readonly Vector2D _start;
    private readonly Vector2D _end;
    private readonly Vector2D _startTangent;
    private readonly Vector2D _endTangent;
    private readonly double _startHeight;
    private readonly double _endHeight;
    private readonly Vector2D _middle;
    private readonly double _radius;
    private readonly double[] _stations = new double[Pieces + 1];

    /// <summary>Creates the curve between two nodes with unit directions on the ground at both.</summary>
    /// <param name="start">Metres, world.</param>
    /// <param name="end">Metres, world.</param>
    /// <param name="startDirection">Unit vector of the road's direction at the start.</param>
    /// <param name="endDirection">Unit vector of the road's direction at the end.</param>
    internal RoadCurve(Vector3D start, Vector3D end, Vector2D startDirection, Vector2D endDirection)
    {
        _start = new Vector2D(start.X, start.Y);
        _end = new Vector2D(end.X, end.Y);
        _startHeight = start.Z;
        _endHeight = end.Z;

        // With end tangents of this length, the cubic best follows a circle through both ends: 2 chord / (1 + cos(bend / 2)).
        double halfBend = Math.Abs(Math.Atan2(startDirection.Cross(endDirection), startDirection.Dot(endDirection))) / 2;
        double length = 2 * (_end - _start).Length / (1 + Math.Cos(halfBend));
        _startTangent = startDirection * length;
        _endTangent = endDirection * length;

        for (int i = 1; i <= Pieces; i++)
        {
            _stations[i] = _stations[i - 1] + LengthBetween((i - 1) / (double)Pieces, i / (double)Pieces);
        }

        // No point of the curve is farther than half its length from its middle along the arc.
        _middle = GroundAt(ParameterAt(Length / 2));
        _radius = Length / 2 * (1 + ArcTolerance);
    }

    /// <summary>Arc length on the ground, metres.</summary>
    public double Length => _stations[Pieces];

    /// <summary>The point at a parameter, metres, world.</summary>
    public Vector3D PointAt(double parameter)
    {
        Vector2D ground = GroundAt(parameter);
        return new Vector3D(ground.X, ground.Y, HeightAt(parameter));
    }

    /// <summary>Unit vector of the direction on the ground, from start to end; the chord's if the derivative is zero.</summary>
    public Vector2D DirectionAt(double parameter)
    {
        Vector2D velocity = VelocityAt(parameter);
        double speed = velocity.Length;
        if (speed > 0)
        {
            return velocity * (1 / speed);
        }

        Vector2D chord = _end - _start;
        return chord.Length > 0 ? chord * (1 / chord.Length) : new Vector2D(0, 1);
    }

    /// <summary>Curvature on the ground, 1/metres; positive where the road turns left from start to end.</summary>
    public double CurvatureAt(double parameter)
    {
        Vector2D velocity = VelocityAt(parameter);
        double speed = velocity.Length;
        // κ = (p' × p'') / |p'|³.
        return speed > 0 ? velocity.Cross(AccelerationAt(parameter)) / (speed * speed * speed) : 0;
    }

    /// <summary>The parameter at a station; stations beyond the ends are clamped.</summary>
    /// <param name="station">Metres from the start.</param>
    public double ParameterAt(double station)
    {
        if (!(station > 0))
        {
            return 0;
        }

        if (station >= Length)
        {
            return 1;
        }

        int piece = 1;
        while (_stations[piece] < station)
        {
            piece++;
        }

        double from = _stations[piece - 1];

        // Linear within the piece, then one Newton step: the arc length grows by the speed |p'| per unit of the parameter.
        double parameter = (piece - 1 + ((station - from) / (_stations[piece] - from))) / Pieces;
        double speed = VelocityAt(parameter).Length;
        double miss = station - from - LengthBetween((piece - 1) / (double)Pieces, parameter);
        return speed > 0 ? Clamp(parameter + (miss / speed)) : parameter;
    }

    /// <summary>The station at a parameter, metres from the start.</summary>
    public double StationAt(double parameter)
    {
        double clamped = Clamp(parameter);
        int piece = Math.Min((int)(clamped * Pieces), Pieces - 1);
        return _stations[piece] + LengthBetween(piece / (double)Pieces, clamped);
    }

    /// <summary>The parameter of the point of the curve closest to a position on the ground, within the link.</summary>
    /// <param name="place">Metres, world.</param>
    public double ClosestParameter(Vector2D place)
    {
        Vector2D chord = _end - _start;
        double square = chord.Dot(chord);
        double parameter = square > 0 ? Clamp((place - _start).Dot(chord) / square) : 0;
        double best = parameter;
        double bestSquare = double.PositiveInfinity;
        for (int i = 0; i <= NewtonSteps; i++)
        {
            Vector2D apart = GroundAt(parameter) - place;
            double apartSquare = apart.Dot(apart);
            if (apartSquare < bestSquare)
            {
                best = parameter;
                bestSquare = apartSquare;
            }

            // Minimises f(t) = |p(t) - place|² / 2 by Newton's method: f' = (p - place) · p', f'' = |p'|² + (p - place) · p''.
            Vector2D velocity = VelocityAt(parameter);
            double slope = apart.Dot(velocity);
            double speedSquare = velocity.Dot(velocity);
            double bend = speedSquare + apart.Dot(AccelerationAt(parameter));

            // Where the distance is not convex because of the bend, the squared speed alone gives a safe step.
            double next = Clamp(parameter - (slope / (bend > 0 ? bend : Math.Max(speedSquare, double.Epsilon))));
            if (Math.Abs(next - parameter) < MinStep)
            {
                break;
            }

            parameter = next;
        }

        return best;
    }

    /// <summary>A point on the ground at an offset, metres to the right of the line, at the line's height.</summary>
    public Vector3D PointBeside(double parameter, double offset)
    {
        Vector2D direction = DirectionAt(parameter);
        Vector3D centre = PointAt(parameter);
        return new Vector3D(centre.X + (direction.Y * offset), centre.Y - (direction.X * offset), centre.Z);
    }

    /// <summary>A part of the curve, as a curve of its own.</summary>
    /// <param name="from">Parameter where it begins.</param>
    /// <param name="to">Parameter where it ends, greater than <paramref name="from"/>.</param>
    public HermiteCurve Between(double from, double to) =>
        // With u from 0 to 1 for t from a to b, dp/du = (b - a) dp/dt; a part of a cubic is the cubic with these ends and derivatives.
        new(PointAt(from), PointAt(to), VelocityAt(from) * (to - from), VelocityAt(to) * (to - from));

    /// <summary>Whether every point of the curve is certainly farther than a distance from a position, by its bounding circle.</summary>
    internal bool IsBeyond(Vector2D place, double distance)
    {
        Vector2D apart = place - _middle;
        double reach = distance + _radius;
        return apart.Dot(apart) > reach * reach;
    }

    /// <summary>Mean rise from start to end, metres per metre along the curve; 0 if it has no length.</summary>
    internal double Slope => Length > 0 ? (_endHeight - _startHeight) / Length : 0;

    internal double HeightAt(double parameter) => _startHeight + ((_endHeight - _startHeight) * parameter);

    internal Vector2D GroundAt(double t)
    {
        // Hermite basis with s = 1 - t: s²(1 + 2t), t·s², t²(3 - 2t) and -t²·s.
        double s = 1 - t;
        return (_start * (s * s * (1 + (2 * t))))
            + (_startTangent * (t * s * s))
            + (_end * (t * t * (3 - (2 * t))))
            - (_endTangent * (t * t * s));
    }

    private static double Clamp(double parameter) =>
        parameter < 0 ? 0
        : parameter > 1 ? 1
        : parameter;

    private Vector2D VelocityAt(double t)
    {
        double s = 1 - t;
        return ((_end - _start) * (6 * t * s)) + (_startTangent * (s * (1 - (3 * t)))) + (_endTangent * (t * ((3 * t) - 2)));
    }

    private Vector2D AccelerationAt(double t) =>
        ((_end - _start) * (6 - (12 * t))) + (_startTangent * ((6 * t) - 4)) + (_endTangent * ((6 * t) - 2));

    /// <summary>Gauss quadrature with three points, exact up to degree five.</summary>
    private double LengthBetween(double from, double to)
    {
        double middle = (from + to) / 2;
        double half = (to - from) / 2;
        double outer = half * Math.Sqrt(0.6);
        return half
            * ((5 * VelocityAt(middle - outer).Length) + (8 * VelocityAt(middle).Length) + (5 * VelocityAt(middle + outer).Length))
            / 9;
    }
}
