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

    private readonly HermiteCurve _line;
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
        // With end tangents of this length, the cubic best follows a circle through both ends: 2 chord / (1 + cos(bend / 2)).
        double halfBend = Math.Abs(Math.Atan2(startDirection.Cross(endDirection), startDirection.Dot(endDirection))) / 2;
        double length = 2 * new Vector2D(end.X - start.X, end.Y - start.Y).Length / (1 + Math.Cos(halfBend));
        _line = new HermiteCurve(start, end, startDirection * length, endDirection * length);

        for (int i = 1; i <= Pieces; i++)
        {
            _stations[i] = _stations[i - 1] + _line.LengthBetween((i - 1) / (double)Pieces, i / (double)Pieces);
        }

        // No point of the curve is farther than half its length from its middle along the arc.
        _middle = GroundAt(ParameterAt(Length / 2));
        _radius = Length / 2 * (1 + ArcTolerance);
    }

    /// <summary>Arc length on the ground, metres.</summary>
    public double Length => _stations[Pieces];

    private Vector2D Chord => new(_line.End.X - _line.Start.X, _line.End.Y - _line.Start.Y);

    /// <summary>The point at a parameter, metres, world.</summary>
    public Vector3D PointAt(double parameter) => _line.PointAt(parameter);

    /// <summary>Unit vector of the direction on the ground, from start to end; the chord's if the derivative is zero.</summary>
    public Vector2D DirectionAt(double parameter)
    {
        Vector2D velocity = _line.VelocityAt(parameter);
        double speed = velocity.Length;
        if (speed > 0)
        {
            return velocity * (1 / speed);
        }

        Vector2D chord = Chord;
        return chord.Length > 0 ? chord * (1 / chord.Length) : new Vector2D(0, 1);
    }

    /// <summary>Curvature on the ground, 1/metres; positive where the road turns left from start to end.</summary>
    public double CurvatureAt(double parameter)
    {
        Vector2D velocity = _line.VelocityAt(parameter);
        double speed = velocity.Length;
        // κ = (p' × p'') / |p'|³.
        return speed > 0 ? velocity.Cross(_line.AccelerationAt(parameter)) / (speed * speed * speed) : 0;
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
        double speed = _line.VelocityAt(parameter).Length;
        double miss = station - from - _line.LengthBetween((piece - 1) / (double)Pieces, parameter);
        return speed > 0 ? Clamp(parameter + (miss / speed)) : parameter;
    }

    /// <summary>The station at a parameter, metres from the start.</summary>
    public double StationAt(double parameter)
    {
        double clamped = Clamp(parameter);
        int piece = Math.Min((int)(clamped * Pieces), Pieces - 1);
        return _stations[piece] + _line.LengthBetween(piece / (double)Pieces, clamped);
    }

    /// <summary>The parameter of the point of the curve closest to a position on the ground, within the link.</summary>
    /// <param name="place">Metres, world.</param>
    public double ClosestParameter(Vector2D place)
    {
        Vector2D chord = Chord;
        double square = chord.Dot(chord);
        double parameter = square > 0 ? Clamp((place - new Vector2D(_line.Start.X, _line.Start.Y)).Dot(chord) / square) : 0;
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
            Vector2D velocity = _line.VelocityAt(parameter);
            double slope = apart.Dot(velocity);
            double speedSquare = velocity.Dot(velocity);
            double bend = speedSquare + apart.Dot(_line.AccelerationAt(parameter));

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
    public HermiteCurve Between(double from, double to) => _line.Between(from, to);

    /// <summary>Whether every point of the curve is certainly farther than a distance from a position, by its bounding circle.</summary>
    internal bool IsBeyond(Vector2D place, double distance)
    {
        Vector2D apart = place - _middle;
        double reach = distance + _radius;
        return apart.Dot(apart) > reach * reach;
    }

    /// <summary>Mean rise from start to end, metres per metre along the curve; 0 if it has no length.</summary>
    internal double Slope => Length > 0 ? (_line.End.Z - _line.Start.Z) / Length : 0;

    internal double HeightAt(double parameter) => _line.HeightAt(parameter);

    internal Vector2D GroundAt(double parameter) => _line.GroundAt(parameter);

    private static double Clamp(double parameter) =>
        parameter < 0 ? 0
        : parameter > 1 ? 1
        : parameter;
}
