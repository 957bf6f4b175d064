using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The flat triangles of a road's asphalt, from station to station and from kerb to kerb. They deviate from the road's curve by
/// centimetres, also in height, so paint is laid on them and not on the curve.
/// </summary>
internal sealed class RoadFacets
{
    private const double MaxStep = 5;
    private const double MinStep = 0.75;

    /// <summary>Maximum deviation of a facet's straight edge from the curve on the ground, metres.</summary>
    private const double Deviation = 0.01;

    /// <summary>
    /// Maximum difference of the lengths of a facet's sides in a bend, metres: on a slope, its two triangles are inclined differently, and
    /// the wider it is, the farther it deviates from the curve.
    /// </summary>
    private const double MaxTwist = 0.25;

    /// <summary>Size of facets where the asphalt of several roads overlaps at different slopes, metres.</summary>
    private const double SharedStep = 2.5;

    /// <summary>Difference of the heights of overlapping roads that is not worth finer facets, metres.</summary>
    private const double Flat = 0.03;

    private readonly Road _road;
    private readonly AsphaltHeights _heights;
    private readonly List<double> _stations = [0];

    /// <summary>The corners at the near and the far side of the facets between two stations, from left to right.</summary>
    private readonly List<(Vector3D[] Near, Vector3D[] Far)> _pieces = [];

    public RoadFacets(Road road, AsphaltHeights heights)
    {
        _road = road;
        _heights = heights;
        double distance = 0;
        while (distance < road.Length)
        {
            double curvature = Math.Max(Math.Abs(road.Curve.CurvatureAt(distance)), Math.Abs(road.Curve.CurvatureAt(distance + MinStep)));
            double step = Math.Clamp(Math.Sqrt(8 * Deviation / Math.Max(curvature, 1e-6)), MinStep, MaxStep);
            double next = distance + (1.5 * step) > road.Length ? road.Length : distance + step;
            Add(distance, next);
            distance = next;
        }
    }

    /// <summary>Stations at which facets begin and end, metres along the road.</summary>
    public IReadOnlyList<double> Stations => _stations;

    /// <summary>
    /// All facets, each with the distance along the road at which it begins, and the offsets of its left and right sides, metres.
    /// </summary>
    public IEnumerable<(RoadFacet Facet, double From, double Left, double Right)> All() =>
        _pieces.SelectMany(
            (piece, number) =>
                Enumerable
                    .Range(1, piece.Near.Length - 1)
                    .Select(column =>
                        (
                            Facet(piece, column),
                            _stations[number],
                            OffsetOf(column - 1, piece.Near.Length - 1),
                            OffsetOf(column, piece.Near.Length - 1)
                        )
                    )
        );

    /// <summary>The point of the asphalt at a distance along the road and an offset to the right of its line, metres, world.</summary>
    public Vector3D At(double distance, double rightOffset)
    {
        int upper = UpperOf(distance);
        (Vector3D[] Near, Vector3D[] Far) piece = _pieces[upper - 1];
        int columns = piece.Near.Length - 1;
        double across = Across(rightOffset) * columns;
        int column = Math.Clamp((int)across, 0, columns - 1);
        return Facet(piece, column + 1).At(Along(upper, distance), across - column);
    }

    /// <summary>Quadrilaterals that cover a strip of the asphalt; each lies in one of the triangles.</summary>
    /// <param name="from">Start of the strip, metres along the road.</param>
    /// <param name="to">End of the strip.</param>
    /// <param name="left">Its left edge, metres to the right of the road's line.</param>
    /// <param name="right">Its right edge.</param>
    public IEnumerable<Vector3D[]> Cover(double from, double to, double left, double right)
    {
        for (int i = UpperOf(from); i < _stations.Count && _stations[i - 1] < to; i++)
        {
            double begin = Math.Max(0, Along(i, from));
            double end = Math.Min(1, Along(i, to));
            if (begin >= end)
            {
                continue;
            }

            (Vector3D[] Near, Vector3D[] Far) piece = _pieces[i - 1];
            int columns = piece.Near.Length - 1;
            for (int column = 0; column < columns; column++)
            {
                double leftAcross = Math.Max(0, (Across(left) * columns) - column);
                double rightAcross = Math.Min(1, (Across(right) * columns) - column);
                if (leftAcross < rightAcross)
                {
                    foreach (Vector3D[] face in Facet(piece, column + 1).Cover(begin, end, leftAcross, rightAcross))
                    {
                        yield return face;
                    }
                }
            }
        }
    }

    /// <summary>The first station at or after a distance, or the last of all; never the first of all.</summary>
    private int UpperOf(double distance)
    {
        int upper = _stations.BinarySearch(distance);
        return Math.Clamp(upper < 0 ? ~upper : upper, 1, _stations.Count - 1);
    }

    private double Along(int upper, double distance) => (distance - _stations[upper - 1]) / (_stations[upper] - _stations[upper - 1]);

    private double Across(double rightOffset) => (rightOffset - _road.LeftKerb) / (_road.RightKerb - _road.LeftKerb);

    /// <summary>Adds the facets between two stations; where roads share the ground at different heights, smaller ones.</summary>
    private void Add(double from, double to)
    {
        int columns = CountColumns(from, to);
        int steps = 1;
        bool isShared = IsShared(from, to);
        if (isShared)
        {
            steps = (int)Math.Ceiling((to - from) / SharedStep);
            columns = Math.Max(columns, (int)Math.Ceiling((_road.RightKerb - _road.LeftKerb) / SharedStep));
        }

        Vector3D[] near = Row(from, columns, isShared);
        for (int i = 1; i <= steps; i++)
        {
            double station = i == steps ? to : from + ((to - from) * i / steps);
            Vector3D[] far = Row(station, columns, isShared);
            _stations.Add(station);
            _pieces.Add((near, far));
            near = far;
        }
    }

    private bool IsShared(double from, double to)
    {
        if (!_heights.IsShared(_road, from, to))
        {
            return false;
        }

        const int lines = 3;
        int across = Math.Max(2, (int)Math.Ceiling((_road.RightKerb - _road.LeftKerb) / SharedStep));
        for (int i = 0; i < lines; i++)
        {
            double distance = from + ((to - from) * i / (lines - 1));
            CrossSection section = _road.Curve.SectionAt(distance);
            for (int column = 0; column <= across; column++)
            {
                double offset = OffsetOf(column, across);
                Vector3D place = section.At(offset);
                (double height, bool isHidden) = _heights.Of(_road, distance, offset, place);
                if (!isHidden && Math.Abs(height - place.Z) > Flat)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private double OffsetOf(int column, int columns) => _road.LeftKerb + ((_road.RightKerb - _road.LeftKerb) * column / columns);

    private Vector3D[] Row(double station, int columns, bool isShared)
    {
        CrossSection section = _road.Curve.SectionAt(station);
        Vector3D[] row = new Vector3D[columns + 1];
        for (int column = 0; column <= columns; column++)
        {
            double offset = OffsetOf(column, columns);
            Vector3D place = section.At(offset);
            row[column] = isShared ? place with { Z = _heights.Of(_road, station, offset, place).Height } : place;
        }

        return row;
    }

    /// <summary>Number of facets side by side between two stations.</summary>
    private int CountColumns(double from, double to)
    {
        Vector3D near = _road.Curve.TangentAt(from);
        Vector3D far = _road.Curve.TangentAt(to);
        double turn = Math.Abs(Math.Atan2((near.X * far.Y) - (near.Y * far.X), (near.X * far.X) + (near.Y * far.Y)));
        return Math.Max(1, (int)Math.Ceiling(turn * (_road.RightKerb - _road.LeftKerb) / MaxTwist));
    }

    private static RoadFacet Facet((Vector3D[] Near, Vector3D[] Far) piece, int right) =>
        new(piece.Near[right - 1], piece.Near[right], piece.Far[right], piece.Far[right - 1]);
}
