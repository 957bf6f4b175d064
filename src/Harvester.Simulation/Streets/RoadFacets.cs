using System;
using System.Collections.Generic;
using System.Linq;
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

    private readonly Road _road;
    private readonly List<double> _stations = [0];
    private readonly List<int> _columns = [0];
    private readonly CrossSection[] _sections;

    public RoadFacets(Road road)
    {
        _road = road;
        double distance = 0;
        while (distance < road.Length)
        {
            double curvature = Math.Max(Math.Abs(road.Curve.CurvatureAt(distance)), Math.Abs(road.Curve.CurvatureAt(distance + MinStep)));
            double step = Math.Clamp(Math.Sqrt(8 * Deviation / Math.Max(curvature, 1e-6)), MinStep, MaxStep);
            distance = distance + (1.5 * step) > road.Length ? road.Length : distance + step;
            _stations.Add(distance);
            _columns.Add(CountColumns(_stations.Count - 1));
        }

        _sections = [.. _stations.Select(road.Curve.SectionAt)];
    }

    /// <summary>Stations at which facets begin and end, metres along the road.</summary>
    public IReadOnlyList<double> Stations => _stations;

    /// <summary>All facets.</summary>
    public IEnumerable<RoadFacet> All()
    {
        for (int i = 1; i < _stations.Count; i++)
        {
            int columns = _columns[i];
            for (int column = 0; column < columns; column++)
            {
                yield return Facet(i, column, columns);
            }
        }
    }

    /// <summary>The point of the asphalt at a distance along the road and an offset to the right of its line, metres, world.</summary>
    public Vector3D At(double distance, double rightOffset)
    {
        int upper = UpperOf(distance);
        int columns = _columns[upper];
        double across = Across(rightOffset) * columns;
        int column = Math.Clamp((int)across, 0, columns - 1);
        return Facet(upper, column, columns).At(Along(upper, distance), across - column);
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

            int columns = _columns[i];
            for (int column = 0; column < columns; column++)
            {
                double leftAcross = Math.Max(0, (Across(left) * columns) - column);
                double rightAcross = Math.Min(1, (Across(right) * columns) - column);
                if (leftAcross < rightAcross)
                {
                    foreach (Vector3D[] face in Facet(i, column, columns).Cover(begin, end, leftAcross, rightAcross))
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

    /// <summary>Number of facets side by side between two stations.</summary>
    private int CountColumns(int upper)
    {
        Vector3D near = _road.Curve.TangentAt(_stations[upper - 1]);
        Vector3D far = _road.Curve.TangentAt(_stations[upper]);
        double turn = Math.Abs(Math.Atan2((near.X * far.Y) - (near.Y * far.X), (near.X * far.X) + (near.Y * far.Y)));
        return Math.Max(1, (int)Math.Ceiling(turn * (_road.RightKerb - _road.LeftKerb) / MaxTwist));
    }

    private RoadFacet Facet(int upper, int column, int columns)
    {
        double width = (_road.RightKerb - _road.LeftKerb) / columns;
        double left = _road.LeftKerb + (column * width);
        return new RoadFacet(
            _sections[upper - 1].At(left),
            _sections[upper - 1].At(left + width),
            _sections[upper].At(left + width),
            _sections[upper].At(left));
    }
}
