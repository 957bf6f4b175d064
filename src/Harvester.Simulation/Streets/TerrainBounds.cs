using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Shapes the ground beside roads: banks up to those on the ground, and cuttings around every road, which win.</summary>
internal sealed class TerrainBounds(TerrainGrid grid)
{
    private readonly double[] _least = Filled(grid, double.NegativeInfinity);
    private readonly double[] _most = Filled(grid, double.PositiveInfinity);
    private readonly float[] _nearest = new float[grid.Width * grid.Height];
    private readonly int[] _sample = new int[grid.Width * grid.Height];
    private readonly int[] _road = new int[grid.Width * grid.Height];
    private readonly List<int> _touched = [];

    /// <param name="roads">The roads.</param>
    /// <param name="levels">Where they are on bridges.</param>
    /// <param name="below">Depth of the ground below a road's line, metres.</param>
    /// <param name="verge">Width of the ground beside a road that does not rise, metres.</param>
    /// <param name="cutting">Rise of the ground beyond it, metres per metre.</param>
    /// <param name="bank">Fall of the ground beside a road, metres per metre.</param>
    /// <param name="reach">Distance from a road's edge at which it shapes the ground, metres.</param>
    public void Apply(IReadOnlyList<Road> roads, RoadLevels levels, double below, double verge, double cutting, double bank, double reach)
    {
        foreach (Road road in roads)
        {
            FindNearest(road, reach);
            foreach (int point in _touched)
            {
                (double aside, double height) = PlaceOf(road, point);
                height -= below;
                _most[point] = Math.Min(_most[point], height + (Math.Max(0, aside - verge) * cutting));
                if (!levels.IsSuspended(road, _sample[point]))
                {
                    _least[point] = Math.Max(_least[point], height - (Math.Max(0, aside - 1) * bank));
                }
            }
        }

        for (int i = 0; i < grid.Width; i++)
        {
            for (int j = 0; j < grid.Height; j++)
            {
                int point = (i * grid.Height) + j;
                grid[i, j] = Math.Min(Math.Max(grid[i, j], _least[point]), _most[point]);
            }
        }
    }

    private static double[] Filled(TerrainGrid grid, double value)
    {
        double[] values = new double[grid.Width * grid.Height];
        Array.Fill(values, value);
        return values;
    }

    /// <summary>Finds the points near a road, and the sample of the road that is nearest to each.</summary>
    private void FindNearest(Road road, double reach)
    {
        _touched.Clear();
        int samples = RoadLevels.CountSamples(road);
        double radius = Math.Max(-road.LeftKerb, road.RightKerb) + WalkwayOf(road) + reach;
        for (int sample = 0; sample < samples; sample++)
        {
            Vector3D place = road.Curve.PositionAt(RoadLevels.DistanceOf(road, sample));
            int lastColumn = Math.Min(grid.Width - 1, grid.ColumnAt(place.X + radius));
            int lastRow = Math.Min(grid.Height - 1, grid.RowAt(place.Y + radius));
            for (int i = Math.Max(0, grid.ColumnAt(place.X - radius) + 1); i <= lastColumn; i++)
            {
                for (int j = Math.Max(0, grid.RowAt(place.Y - radius) + 1); j <= lastRow; j++)
                {
                    int point = (i * grid.Height) + j;
                    double dx = grid.XOf(i) - place.X;
                    double dy = grid.YOf(j) - place.Y;
                    float squared = (float)((dx * dx) + (dy * dy));
                    if (squared > radius * radius)
                    {
                        continue;
                    }

                    if (_road[point] != road.Index + 1)
                    {
                        _road[point] = road.Index + 1;
                        _touched.Add(point);
                        _nearest[point] = float.PositiveInfinity;
                    }

                    if (squared < _nearest[point])
                    {
                        _nearest[point] = squared;
                        _sample[point] = sample;
                    }
                }
            }
        }
    }

    /// <summary>Distance of a point from the road's outer edge, metres, and the height of the road beside it.</summary>
    private (double Aside, double Height) PlaceOf(Road road, int point)
    {
        double distance = RoadLevels.DistanceOf(road, _sample[point]);
        Vector3D centre = road.Curve.PositionAt(distance);
        Vector3D tangent = road.Curve.TangentAt(distance);
        double x = grid.XOf(point / grid.Height) - centre.X;
        double y = grid.YOf(point % grid.Height) - centre.Y;
        double level = Math.Sqrt((tangent.X * tangent.X) + (tangent.Y * tangent.Y));
        double along = ((x * tangent.X) + (y * tangent.Y)) / level;
        double right = ((x * tangent.Y) - (y * tangent.X)) / level;
        double beside = Math.Max(right - road.RightKerb, road.LeftKerb - right) - WalkwayOf(road);
        double beyond = Math.Max(0, Math.Abs(along) - RoadLevels.Step);
        double slope = tangent.Z / level;
        return (
            beyond > 0 ? Math.Sqrt((Math.Max(0, beside) * Math.Max(0, beside)) + (beyond * beyond)) : beside,
            centre.Z + (slope * Math.Clamp(along, -RoadLevels.Step, RoadLevels.Step))
        );
    }

    private static double WalkwayOf(Road road) => road.IsStreet ? Walkway.Width : 0;
}
