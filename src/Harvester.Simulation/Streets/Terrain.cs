using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The ground around the roads: a grid of heights slightly below the lowest road at each point, interpolated smoothly between the roads. A
/// road high above it is on a bridge.
/// </summary>
internal sealed class Terrain
{
    private const double CellSize = 10;
    private const double Margin = 160;
    private const double SampleStep = 5;
    private const double BelowRoad = 0.4;
    private const double BridgeHeight = 5;
    private const int SmoothingRounds = 80;

    private readonly double _west;
    private readonly double _south;
    private readonly double[,] _heights;

    public Terrain(RoadPlan plan)
    {
        List<(Vector3D Place, double Reach)> samples = [.. plan.Roads.SelectMany(Samples)];
        _west = samples.Min(sample => sample.Place.X) - Margin;
        _south = samples.Min(sample => sample.Place.Y) - Margin;
        int columns = 2 + (int)((samples.Max(sample => sample.Place.X) + Margin - _west) / CellSize);
        int rows = 2 + (int)((samples.Max(sample => sample.Place.Y) + Margin - _south) / CellSize);
        double[,] lowest = Lowest(samples, columns, rows);
        _heights = Fill(lowest);
        foreach ((Vector3D place, double reach) in samples)
        {
            KeepBelow(place, reach);
        }
    }

    /// <summary>Height of the ground, metres; outside the grid that of its border.</summary>
    public double HeightAt(Vector3D place)
    {
        double x = Math.Clamp((place.X - _west) / CellSize, 0, _heights.GetLength(0) - 1.001);
        double y = Math.Clamp((place.Y - _south) / CellSize, 0, _heights.GetLength(1) - 1.001);
        int i = (int)x;
        int j = (int)y;
        double u = x - i;
        double v = y - j;
        return u > v
            ? _heights[i, j] + (u * (_heights[i + 1, j] - _heights[i, j])) + (v * (_heights[i + 1, j + 1] - _heights[i + 1, j]))
            : _heights[i, j] + (v * (_heights[i, j + 1] - _heights[i, j])) + (u * (_heights[i + 1, j + 1] - _heights[i, j + 1]));
    }

    public void Build(GroundMesh mesh)
    {
        int columns = _heights.GetLength(0);
        int rows = _heights.GetLength(1);
        for (int i = 0; i < columns - 1; i++)
        {
            for (int j = 0; j < rows - 1; j++)
            {
                // Patches of drier grass, in waves that do not repeat with the grid.
                double dryness = 0.5 + (0.5 * Math.Sin((i * 0.37) + (2 * Math.Sin(j * 0.23))));
                Rgb colour = Palette.Grass.Towards(Palette.DryGrass, dryness);
                mesh.AddTriangle(Corner(i, j), Corner(i + 1, j), Corner(i + 1, j + 1), colour, Surface.Ground);
                mesh.AddTriangle(Corner(i, j), Corner(i + 1, j + 1), Corner(i, j + 1), colour, Surface.Ground);
            }
        }

        AddSurroundings(mesh, columns, rows);
    }

    private static IEnumerable<(Vector3D Place, double Reach)> Samples(Road road)
    {
        int steps = Math.Max(1, (int)Math.Ceiling(road.Length / SampleStep));
        double reach = road.Layout.HalfWidth + road.Shoulder + Walkway.Width + (CellSize * Math.Sqrt(2));
        return Enumerable.Range(0, steps + 1).Select(i => (road.Curve.PositionAt(road.Length * i / steps), reach));
    }

    /// <summary>The height of the lowest road in each cell, ignoring bridges over it; NaN if there is no road.</summary>
    private double[,] Lowest(List<(Vector3D Place, double Reach)> samples, int columns, int rows)
    {
        double[,] lowest = new double[columns, rows];
        foreach (ref double height in System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref lowest[0, 0], lowest.Length))
        {
            height = double.NaN;
        }

        foreach ((Vector3D place, _) in samples)
        {
            int i = (int)Math.Round((place.X - _west) / CellSize);
            int j = (int)Math.Round((place.Y - _south) / CellSize);
            lowest[i, j] = double.IsNaN(lowest[i, j]) ? place.Z : Math.Min(lowest[i, j], place.Z);
        }

        double[,] grounded = (double[,])lowest.Clone();
        for (int i = 2; i < columns - 2; i++)
        {
            for (int j = 2; j < rows - 2; j++)
            {
                for (int k = 0; k < 25; k++)
                {
                    double neighbour = lowest[i - 2 + (k / 5), j - 2 + (k % 5)];
                    grounded[i, j] = neighbour < lowest[i, j] - BridgeHeight ? double.NaN : grounded[i, j];
                }
            }
        }

        return grounded;
    }

    /// <summary>Fills the gaps: first from the nearest road, then smoothed as a membrane fixed at the roads.</summary>
    private static double[,] Fill(double[,] known)
    {
        int columns = known.GetLength(0);
        int rows = known.GetLength(1);
        double[,] heights = (double[,])known.Clone();
        Queue<(int X, int Y)> open = new();
        for (int i = 0; i < columns; i++)
        {
            for (int j = 0; j < rows; j++)
            {
                if (!double.IsNaN(known[i, j]))
                {
                    open.Enqueue((i, j));
                }
            }
        }

        while (open.TryDequeue(out (int X, int Y) cell))
        {
            foreach ((int x, int y) in new[] { (cell.X - 1, cell.Y), (cell.X + 1, cell.Y), (cell.X, cell.Y - 1), (cell.X, cell.Y + 1) })
            {
                if (x >= 0 && y >= 0 && x < columns && y < rows && double.IsNaN(heights[x, y]))
                {
                    heights[x, y] = heights[cell.X, cell.Y];
                    open.Enqueue((x, y));
                }
            }
        }

        for (int round = 0; round < SmoothingRounds; round++)
        {
            for (int i = 0; i < columns; i++)
            {
                for (int j = 0; j < rows; j++)
                {
                    if (double.IsNaN(known[i, j]))
                    {
                        heights[i, j] = (heights[Math.Max(i - 1, 0), j] + heights[Math.Min(i + 1, columns - 1), j]
                            + heights[i, Math.Max(j - 1, 0)] + heights[i, Math.Min(j + 1, rows - 1)]) / 4;
                    }
                }
            }
        }

        return heights;
    }

    private void KeepBelow(Vector3D place, double reach)
    {
        int columns = _heights.GetLength(0);
        int rows = _heights.GetLength(1);
        for (int i = Math.Max(0, (int)((place.X - reach - _west) / CellSize)); i < columns && (i * CellSize) + _west < place.X + reach; i++)
        {
            for (int j = Math.Max(0, (int)((place.Y - reach - _south) / CellSize)); j < rows
                && (j * CellSize) + _south < place.Y + reach; j++)
            {
                if (Horizontal.SquaredDistance(Corner(i, j), place) < reach * reach)
                {
                    _heights[i, j] = Math.Min(_heights[i, j], place.Z - BelowRoad);
                }
            }
        }
    }

    private Vector3D Corner(int i, int j) => new(_west + (i * CellSize), _south + (j * CellSize), _heights[i, j]);

    /// <summary>Adds flat land from the grid's border to the horizon.</summary>
    private void AddSurroundings(GroundMesh mesh, int columns, int rows)
    {
        const double horizon = 3000;
        Vector3D middle = Corner(columns / 2, rows / 2);
        List<Vector3D> border = [];
        border.AddRange(Enumerable.Range(0, columns - 1).Select(i => Corner(i, 0)));
        border.AddRange(Enumerable.Range(0, rows - 1).Select(j => Corner(columns - 1, j)));
        border.AddRange(Enumerable.Range(1, columns - 1).Reverse().Select(i => Corner(i, rows - 1)));
        border.AddRange(Enumerable.Range(1, rows - 1).Reverse().Select(j => Corner(0, j)));
        for (int i = 0; i < border.Count; i++)
        {
            Vector3D a = border[i];
            Vector3D b = border[(i + 1) % border.Count];
            Vector3D farA = a + (((a - middle) with { Z = 0 }).Normalized() * horizon);
            Vector3D farB = b + (((b - middle) with { Z = 0 }).Normalized() * horizon);
            mesh.AddQuad(a, farA, farB, b, Palette.Grass, Surface.Ground);
        }
    }
}
