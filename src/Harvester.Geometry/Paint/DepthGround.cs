using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The ground seen in a depth map: in each square cell, the median height of the pixels put back into the world. Between the centres of
/// four cells, heights are interpolated bilinearly.
/// </summary>
public sealed class DepthGround : IPaintGround
{
    /// <summary>Side of a cell, metres: narrow enough for the crown of a road, wide enough for several pixels.</summary>
    private const double Cell = 0.5;

    /// <summary>Farthest pixel that is used, metres of depth: beyond it a cell has too few pixels.</summary>
    private const double MaxDepth = 40;

    /// <summary>
    /// Cells farther than this from the height of the road network are walls, roofs, other roads, metres.
    /// </summary>
    private const double MaxMisfit = 1.5;

    /// <summary>Standard deviation of a cell's height, metres: relief of asphalt and quantised depths.</summary>
    private const double Sigma = 0.01;

    private const int MinPixels = 2;

    /// <summary>Cells to each side whose median a cell is compared with: wider than a vehicle.</summary>
    private const int Neighbours = 4;

    /// <summary>
    /// A cell that is higher or lower than the median of its neighbours by more than this is a vehicle, a kerb or a rail, metres; over 2 m
    /// a road with a slope of 7 % rises as much.
    /// </summary>
    private const double MaxStep = 0.15;

    private readonly Dictionary<(int X, int Y), double> _heights = [];

    /// <summary>Creates the ground.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="depths">Depth along the camera's axis, metres, row by row; not finite or not positive where it is unknown.</param>
    /// <param name="hidden">One byte per pixel, other than 0 where something else than ground is seen; null if nothing is.</param>
    /// <exception cref="ArgumentException">The array has another size than the camera's image.</exception>
    public DepthGround(Camera camera, float[] depths, byte[]? hidden)
    {
        ImageSize size = Guard.NotNull(camera, nameof(camera)).Image;
        if (Guard.NotNull(depths, nameof(depths)).Length != size.PixelCount)
        {
            throw new ArgumentException("The depth map must have the size of the camera's image.", nameof(depths));
        }

        Dictionary<(int X, int Y), double> medians = Medians(camera, depths, hidden);
        foreach (KeyValuePair<(int X, int Y), double> cell in medians)
        {
            if (Math.Abs(cell.Value - Around(medians, cell.Key)) <= MaxStep)
            {
                _heights.Add(cell.Key, cell.Value);
            }
        }
    }

    /// <inheritdoc/>
    public double HeightAt(Vector3D place)
    {
        double x = (place.X / Cell) - 0.5;
        double y = (place.Y / Cell) - 0.5;
        (int left, int below) = ((int)Math.Floor(x), (int)Math.Floor(y));
        double sum = 0;
        double weights = 0;
        for (int i = 0; i < 4; i++)
        {
            (int column, int row) = (left + (i & 1), below + (i >> 1));
            double weight = (1 - Math.Abs(x - column)) * (1 - Math.Abs(y - row));
            if (_heights.TryGetValue((column, row), out double height) && Math.Abs(height - place.Z) <= MaxMisfit)
            {
                sum += weight * height;
                weights += weight;
            }
        }

        return weights > 0 ? sum / weights : double.NaN;
    }

    /// <inheritdoc/>
    public double SigmaAt(double distance) => Sigma;

    private static Dictionary<(int X, int Y), double> Medians(Camera camera, float[] depths, byte[]? hidden)
    {
        int width = camera.Image.Width;
        var cells = new Dictionary<(int X, int Y), List<double>>();
        for (int i = 0; i < depths.Length; i++)
        {
            double depth = depths[i];
            if (depth > 0 && depth <= MaxDepth && (hidden is null || hidden[i] == 0))
            {
                Vector3D point = camera.Unproject((i % width) + 0.5, (i / width) + 0.5, depth);
                if (point.Z < camera.Pose.Position.Z)
                {
                    (int, int) cell = ((int)Math.Floor(point.X / Cell), (int)Math.Floor(point.Y / Cell));
                    if (!cells.TryGetValue(cell, out List<double>? heights))
                    {
                        cells.Add(cell, heights = []);
                    }

                    heights.Add(point.Z);
                }
            }
        }

        var medians = new Dictionary<(int X, int Y), double>();
        foreach (KeyValuePair<(int, int), List<double>> cell in cells)
        {
            if (cell.Value.Count >= MinPixels)
            {
                cell.Value.Sort();
                medians.Add(cell.Key, cell.Value[cell.Value.Count / 2]);
            }
        }

        return medians;
    }

    private static double Around(Dictionary<(int X, int Y), double> medians, (int X, int Y) cell)
    {
        var around = new List<double>();
        for (int x = cell.X - Neighbours; x <= cell.X + Neighbours; x++)
        {
            for (int y = cell.Y - Neighbours; y <= cell.Y + Neighbours; y++)
            {
                if (medians.TryGetValue((x, y), out double height))
                {
                    around.Add(height);
                }
            }
        }

        around.Sort();
        return around[around.Count / 2];
    }
}
