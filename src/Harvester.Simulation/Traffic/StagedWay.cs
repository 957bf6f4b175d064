using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>The path of a staged actor: points joined by straight pieces, with a direction that turns gradually at them.</summary>
internal sealed class StagedWay
{
    /// <summary>The direction at a place is that from so far behind it to so far ahead, metres.</summary>
    private const double Chord = 1.2;

    private readonly Vector3D[] _points;
    private readonly double[] _distances;

    /// <param name="points">At least two; neighbours must differ on the ground.</param>
    /// <exception cref="ArgumentException">There are fewer than two points.</exception>
    public StagedWay(IReadOnlyList<Vector3D> points)
    {
        if (points.Count < 2)
        {
            throw new ArgumentException("A path has at least two points.", nameof(points));
        }

        _points = [.. points];
        _distances = new double[_points.Length];
        for (int i = 1; i < _points.Length; i++)
        {
            _distances[i] = _distances[i - 1] + Horizontal.Distance(_points[i], _points[i - 1]);
        }
    }

    public double Length => _distances[^1];

    /// <summary>The place at a distance; before the start and past the end the outer pieces are prolonged.</summary>
    public Vector3D PositionAt(double distance)
    {
        int found = Array.BinarySearch(_distances, distance);
        int index = Math.Clamp(found >= 0 ? found : ~found - 1, 0, _points.Length - 2);
        double fraction = (distance - _distances[index]) / (_distances[index + 1] - _distances[index]);
        return _points[index] + ((_points[index + 1] - _points[index]) * fraction);
    }

    /// <summary>Horizontal unit direction along the path.</summary>
    public Vector3D DirectionAt(double distance)
    {
        Vector3D chord = PositionAt(distance + Chord) - PositionAt(distance - Chord);
        return new Vector3D(chord.X, chord.Y, 0).Normalized();
    }

    /// <summary>Metres along the path to the point that is nearest to a place on the ground.</summary>
    public double Nearest(Vector3D place)
    {
        double best = 0;
        double least = double.PositiveInfinity;
        for (int i = 1; i < _points.Length; i++)
        {
            Vector3D piece = (_points[i] - _points[i - 1]) with { Z = 0 };
            double length = _distances[i] - _distances[i - 1];
            double along = Math.Clamp((place - _points[i - 1]).Dot(piece) / length, 0, length);
            double squared = Horizontal.SquaredDistance(_points[i - 1] + (piece * (along / length)), place);
            if (squared < least)
            {
                (least, best) = (squared, _distances[i - 1] + along);
            }
        }

        return best;
    }
}
