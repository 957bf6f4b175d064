using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>A path made of short straight pieces, with the distance along it in metres.</summary>
internal sealed class Polyline
{
    private readonly Vector3D[] _points;
    private readonly Vector3D[] _tangents;
    private readonly double[] _distances;
    private readonly double[] _bends;

    /// <param name="points">At least two; neighbours must differ.</param>
    /// <param name="tangents">The unit direction of the smooth path at each point.</param>
    public Polyline(IReadOnlyList<Vector3D> points, IReadOnlyList<Vector3D> tangents)
    {
        _points = [.. points];
        _tangents = [.. tangents];
        _distances = new double[_points.Length];
        for (int i = 1; i < _points.Length; i++)
        {
            _distances[i] = _distances[i - 1] + (_points[i] - _points[i - 1]).Length;
        }

        _bends = new double[_points.Length - 1];
        for (int i = 0; i < _bends.Length; i++)
        {
            _bends[i] = Math.Abs(Horizontal.Turn(_tangents[i], _tangents[i + 1])) / (_distances[i + 1] - _distances[i]);
        }
    }

    public double Length => _distances[^1];

    public IReadOnlyList<Vector3D> Points => _points;

    public Vector3D PositionAt(double distance)
    {
        (int index, double fraction) = Find(distance);
        return PositionIn(index, fraction);
    }

    /// <summary>The position at a distance and the unit direction along the way.</summary>
    public (Vector3D Position, Vector3D Tangent) At(double distance)
    {
        (int index, double fraction) = Find(distance);
        return (PositionIn(index, fraction), TangentIn(index, fraction));
    }

    /// <summary>Unit direction along the path.</summary>
    public Vector3D TangentAt(double distance)
    {
        (int index, double fraction) = Find(distance);
        return TangentIn(index, fraction);
    }

    /// <summary>Curvature of the path at a distance, 1/m.</summary>
    public double BendAt(double distance) => _bends[PieceAt(distance)];

    private Vector3D PositionIn(int index, double fraction) => _points[index] + ((_points[index + 1] - _points[index]) * fraction);

    private Vector3D TangentIn(int index, double fraction) =>
        (_tangents[index] + ((_tangents[index + 1] - _tangents[index]) * fraction)).Normalized();

    private (int Index, double Fraction) Find(double distance)
    {
        int index = PieceAt(distance);
        double fraction = (distance - _distances[index]) / (_distances[index + 1] - _distances[index]);
        return (index, Math.Clamp(fraction, 0, 1));
    }

    private int PieceAt(double distance)
    {
        // Points are nearly evenly spaced, so the right piece is next to the one at the proportional index.
        int last = _points.Length - 2;
        int index = (int)Math.Clamp(distance / Length * (last + 1), 0, last);
        while (index > 0 && _distances[index] > distance)
        {
            index--;
        }

        while (index < last && _distances[index + 1] <= distance)
        {
            index++;
        }

        return index;
    }
}
