using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.World;

/// <summary>Lays strips of one colour along a road's curve.</summary>
internal sealed class RoadRibbon
{
    private const double LongestStep = 5;
    private const double ShortestStep = 0.75;

    /// <summary>Largest deviation of a strip's straight edge from the curve, metres.</summary>
    private const double Deviation = 0.01;

    private readonly Road _road;
    private readonly GroundMesh _mesh;
    private readonly List<double> _stations = [0];

    public RoadRibbon(Road road, GroundMesh mesh)
    {
        _road = road;
        _mesh = mesh;
        double distance = 0;
        while (distance < road.Length)
        {
            double curvature = Math.Max(Math.Abs(road.Curve.CurvatureAt(distance)), Math.Abs(road.Curve.CurvatureAt(distance + ShortestStep)));
            double step = Math.Clamp(Math.Sqrt(8 * Deviation / Math.Max(curvature, 1e-6)), ShortestStep, LongestStep);
            distance = distance + (1.5 * step) > road.Length ? road.Length : distance + step;
            _stations.Add(distance);
        }
    }

    /// <summary>A strip along the whole road, left out where a test of a piece's middle says no.</summary>
    public void Lay(Rail left, Rail right, Rgb colour, Surface surface, Func<double, bool>? isPresent = null)
    {
        for (int i = 1; i < _stations.Count; i++)
        {
            if (isPresent?.Invoke((_stations[i - 1] + _stations[i]) / 2) ?? true)
            {
                Piece(_stations[i - 1], _stations[i], left, right, colour, surface);
            }
        }
    }

    /// <summary>A strip from one distance to another.</summary>
    public void LayBetween(double from, double to, Rail left, Rail right, Rgb colour, Surface surface)
    {
        double start = from;
        foreach (double station in _stations)
        {
            if (station > start && station < to)
            {
                Piece(start, station, left, right, colour, surface);
                start = station;
            }
        }

        Piece(start, to, left, right, colour, surface);
    }

    private void Piece(double from, double to, Rail left, Rail right, Rgb colour, Surface surface) =>
        _mesh.AddQuad(Place(from, left), Place(from, right), Place(to, right), Place(to, left), colour, surface);

    private Vector3D Place(double distance, Rail rail) =>
        _road.Curve.OffsetAt(distance, rail.RightOffset) + (Horizontal.Up * rail.Height);
}
