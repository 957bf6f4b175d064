using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The ground around the roads. It is slightly below every road, follows the roads that do not cross others on a bridge, with banks and
/// cuttings beside them, and runs smoothly between the roads.
/// </summary>
internal sealed class Terrain
{
    private const double Margin = 160;

    /// <summary>Depth of the ground below a road's line, metres: more than the ground is uneven within a large triangle.</summary>
    private const double BelowRoad = 0.4;

    /// <summary>Width of the ground beside a road that does not rise above it, metres: the diagonal of a small triangle.</summary>
    private const double Verge = 3.6;

    /// <summary>Rise of a cutting and fall of a bank, metres per metre.</summary>
    private const double Cutting = 0.9;

    private const double Bank = 0.55;

    /// <summary>Distance from a road's edge at which it no longer shapes the ground, metres.</summary>
    private const double Reach = 16;

    private const int SmoothingRounds = 80;

    private readonly TerrainGrid _grid;

    public Terrain(RoadPlan plan, RoadLevels levels)
    {
        List<(Vector3D Place, bool IsGround)> samples = [.. plan.Roads.SelectMany(road => Samples(road, levels))];
        double west = samples.Min(sample => sample.Place.X) - Margin;
        double south = samples.Min(sample => sample.Place.Y) - Margin;
        int columns = 2 + (int)((samples.Max(sample => sample.Place.X) + Margin - west) / TerrainGrid.CellSize);
        int rows = 2 + (int)((samples.Max(sample => sample.Place.Y) + Margin - south) / TerrainGrid.CellSize);
        _grid = new TerrainGrid(west, south, columns, rows);
        bool hasGround = samples.Any(sample => sample.IsGround);
        double[,] known = new double[columns + 1, rows + 1];
        System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref known[0, 0], known.Length).Fill(double.NaN);
        foreach ((Vector3D place, bool isGround) in samples)
        {
            if (isGround || !hasGround)
            {
                ref double lowest = ref known[
                    (int)Math.Round((place.X - west) / TerrainGrid.CellSize),
                    (int)Math.Round((place.Y - south) / TerrainGrid.CellSize)
                ];
                lowest = double.IsNaN(lowest) ? place.Z - BelowRoad : Math.Min(lowest, place.Z - BelowRoad);
            }
        }

        Refine(Fill(known));
        new TerrainBounds(_grid).Apply(plan.Roads, levels, BelowRoad, Verge, Cutting, Bank, Reach);
        _grid.Finish();
    }

    /// <summary>Height of the ground, metres; outside the grid that of its border.</summary>
    public double HeightAt(Vector3D place) => _grid.HeightAt(place);

    public void Build(GroundMesh mesh, Settlement settlement)
    {
        foreach ((Vector3D a, Vector3D b, Vector3D c) in _grid.Triangles())
        {
            mesh.AddTriangle(a, b, c, LandColours.Of(settlement.At(a), a, b, c), Surface.Ground, SurfaceKind.Terrain);
        }

        AddSurroundings(mesh, settlement);
    }

    private static IEnumerable<(Vector3D Place, bool IsGround)> Samples(Road road, RoadLevels levels) =>
        Enumerable
            .Range(0, RoadLevels.CountSamples(road))
            .Select(i => (road.Curve.PositionAt(RoadLevels.DistanceOf(road, i)), !levels.IsSuspended(road, i)));

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

        // Heights spread from the roads: each cell takes that of the nearest known one.
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

        // Relaxation towards Laplace's equation: each unknown height becomes the mean of its neighbours, so slopes even out between roads.
        for (int round = 0; round < SmoothingRounds; round++)
        {
            for (int i = 0; i < columns; i++)
            {
                for (int j = 0; j < rows; j++)
                {
                    if (double.IsNaN(known[i, j]))
                    {
                        heights[i, j] =
                            (
                                heights[Math.Max(i - 1, 0), j]
                                + heights[Math.Min(i + 1, columns - 1), j]
                                + heights[i, Math.Max(j - 1, 0)]
                                + heights[i, Math.Min(j + 1, rows - 1)]
                            ) / 4;
                    }
                }
            }
        }

        return heights;
    }

    /// <summary>Sets the heights of the smaller cells between those of the large ones.</summary>
    private void Refine(double[,] heights)
    {
        const int split = TerrainGrid.Split;
        for (int i = 0; i < _grid.Width; i++)
        {
            for (int j = 0; j < _grid.Height; j++)
            {
                int x = Math.Min(i / split, _grid.Columns - 1);
                int y = Math.Min(j / split, _grid.Rows - 1);

                // Bilinear interpolation within a cell.
                double u = ((double)i / split) - x;
                double v = ((double)j / split) - y;
                _grid[i, j] =
                    (heights[x, y] * (1 - u) * (1 - v))
                    + (heights[x + 1, y] * u * (1 - v))
                    + (heights[x, y + 1] * (1 - u) * v)
                    + (heights[x + 1, y + 1] * u * v);
            }
        }
    }

    /// <summary>Adds flat land from the grid's border to the horizon.</summary>
    private void AddSurroundings(GroundMesh mesh, Settlement settlement)
    {
        const double horizon = 3000;
        Vector3D middle = _grid.Corner(_grid.Width / 2, _grid.Height / 2);
        List<Vector3D> border = _grid.Border();
        for (int i = 0; i < border.Count; i++)
        {
            Vector3D a = border[i];
            Vector3D b = border[(i + 1) % border.Count];
            Vector3D farA = a + (((a - middle) with { Z = 0 }).Normalized() * horizon);
            Vector3D farB = b + (((b - middle) with { Z = 0 }).Normalized() * horizon);
            mesh.AddQuad(a, farA, farB, b, LandColours.Of(settlement.At(a), a, farA, farB), Surface.Ground, SurfaceKind.Terrain);
        }
    }
}
