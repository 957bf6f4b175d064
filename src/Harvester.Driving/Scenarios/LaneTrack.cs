using Harvester.Geometry;

namespace Harvester.Driving.Scenarios;

/// <summary>A line along lanes, with the distance along it in metres; the start of a scenario's ego is often its zero.</summary>
public sealed class LaneTrack
{
    /// <summary>Points nearer than this to the one before are left out, metres.</summary>
    private const double Nearest = 0.05;

    /// <summary>The direction at a place is that from so far behind it to so far ahead, metres.</summary>
    private const double Chord = 1;

    private readonly List<Vector3D> _points = [];
    private readonly List<double> _at = [];

    /// <summary>Joins points.</summary>
    /// <param name="points">At least two that differ, metres, world.</param>
    /// <param name="first">The distance of the first point, metres.</param>
    /// <exception cref="ArgumentException">Fewer than two points differ.</exception>
    public LaneTrack(IEnumerable<Vector3D> points, double first = 0)
    {
        foreach (Vector3D point in points ?? throw new ArgumentNullException(nameof(points)))
        {
            double step = _points.Count == 0 ? 0 : Level(point - _points[_points.Count - 1]).Length;
            if (_points.Count == 0 || step > Nearest)
            {
                _at.Add(_points.Count == 0 ? first : _at[_at.Count - 1] + step);
                _points.Add(point);
            }
        }

        if (_points.Count < 2)
        {
            throw new ArgumentException("A track has at least two points.", nameof(points));
        }
    }

    /// <summary>The distance of its first point, metres.</summary>
    public double From => _at[0];

    /// <summary>The distance of its last point, metres.</summary>
    public double To => _at[_at.Count - 1];

    /// <summary>Its points, metres, world.</summary>
    public IReadOnlyList<Vector3D> Points => _points;

    /// <summary>The same line driven the other way; the distance 0 stays where it is.</summary>
    public LaneTrack Reversed() => new(Enumerable.Reverse(_points), -To);

    /// <summary>The same line with another zero.</summary>
    /// <param name="by">What is taken off each distance, metres.</param>
    public LaneTrack Shifted(double by) => new(_points, From - by);

    /// <summary>The point at a distance; before the start and past the end the outer pieces are prolonged.</summary>
    public Vector3D PositionAt(double at)
    {
        int i = PieceAt(at);
        return _points[i] + ((_points[i + 1] - _points[i]) * ((at - _at[i]) / (_at[i + 1] - _at[i])));
    }

    /// <summary>Horizontal unit direction at a distance.</summary>
    public Vector3D DirectionAt(double at) => Level(PositionAt(at + Chord) - PositionAt(at - Chord)).Normalized();

    /// <summary>Horizontal unit vector to the right at a distance.</summary>
    public Vector3D RightAt(double at)
    {
        Vector3D forward = DirectionAt(at);
        return new Vector3D(forward.Y, -forward.X, 0);
    }

    /// <summary>The point beside a distance.</summary>
    /// <param name="at">Metres along the track.</param>
    /// <param name="right">Metres to the right.</param>
    public Vector3D Beside(double at, double right) => PositionAt(at) + (RightAt(at) * right);

    /// <summary>The distance and the offset to the right of the point nearest to a place, metres.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="near">Only points within 60 m of this distance are looked at; null to look at all.</param>
    public (double At, double Right) Locate(Vector3D place, double? near = null)
    {
        const double window = 60;
        double best = near is { } middle ? Math.Max(From, Math.Min(To, middle)) : From;
        double least = double.PositiveInfinity;
        for (int i = 1; i < _points.Count; i++)
        {
            if (near is { } around && (_at[i] < around - window || _at[i - 1] > around + window))
            {
                continue;
            }

            Vector3D piece = Level(_points[i] - _points[i - 1]);
            double length = _at[i] - _at[i - 1];
            double raw = Level(place - _points[i - 1]).Dot(piece) / length;

            // Before the start and past the end the outer pieces are prolonged.
            double along = Math.Max(
                i == 1 ? double.NegativeInfinity : 0,
                Math.Min(i == _points.Count - 1 ? double.PositiveInfinity : length, raw)
            );
            double distance = Level(place - (_points[i - 1] + (piece * (along / length)))).Length;
            if (distance < least)
            {
                (least, best) = (distance, _at[i - 1] + along);
            }
        }

        return (best, (place - PositionAt(best)).Dot(RightAt(best)));
    }

    /// <summary>Points of the track, or beside it, from one distance to another.</summary>
    /// <param name="from">Metres.</param>
    /// <param name="to">Metres; more than <paramref name="from"/>.</param>
    /// <param name="rightAt">Metres to the right at a distance; null for none.</param>
    public IReadOnlyList<Vector3D> Path(double from, double to, Func<double, double>? rightAt = null)
    {
        const double step = 1.5;
        int pieces = Math.Max(1, (int)Math.Ceiling((to - from) / step));
        var path = new List<Vector3D>(pieces + 1);
        for (int i = 0; i <= pieces; i++)
        {
            double at = from + ((to - from) * i / pieces);
            path.Add(rightAt is null ? PositionAt(at) : Beside(at, rightAt(at)));
        }

        return path;
    }

    private static Vector3D Level(Vector3D vector) => new(vector.X, vector.Y, 0);

    private int PieceAt(double at)
    {
        int found = _at.BinarySearch(at);
        return Math.Max(0, Math.Min(found >= 0 ? found : ~found - 1, _at.Count - 2));
    }
}
