namespace Harvester.Geometry.Paint;

/// <summary>
/// The colours along a line on the ground, in cells of equal length, as an image shows them; several such lines can be averaged. It is used
/// again and again, so that it allocates nothing.
/// </summary>
internal sealed class GroundProfile
{
    /// <summary>Nearest depth of ground, metres.</summary>
    private const double MinDepth = 0.5;

    /// <summary>What is nearer than the ground by this fraction stands on it: 1 m in 20, the length of road behind 8 cm of
    /// height.</summary>
    public const double MaxDepthTolerance = 0.05;

    /// <summary>Distance between places of a line at which the height of the ground is taken, metres.</summary>
    private const double KnotStep = 1;

    /// <summary>Mean of red and green, per cell; after <see cref="Add"/> the sum over the lines.</summary>
    public float[] Bright { get; private set; } = [];

    /// <summary>Blue, per cell; after <see cref="Add"/> the sum over the lines.</summary>
    public float[] Blue { get; private set; } = [];

    /// <summary>The number of lines of which the image shows the cell.</summary>
    public int[] Count { get; private set; } = [];

    /// <summary>Greatest depth of ground, metres along the camera's axis.</summary>
    public double MaxDepth { get; set; } = double.PositiveInfinity;

    /// <summary>Fraction by which things nearer than the ground are taken for ground.</summary>
    public double DepthTolerance { get; set; } = MaxDepthTolerance;

    /// <summary>Empties it.</summary>
    /// <param name="cells">Number of cells.</param>
    public void Clear(int cells)
    {
        if (Bright.Length < cells)
        {
            Bright = new float[cells];
            Blue = new float[cells];
            Count = new int[cells];
        }

        Array.Clear(Bright, 0, cells);
        Array.Clear(Blue, 0, cells);
        Array.Clear(Count, 0, cells);
    }

    /// <summary>Divides the sums by the number of lines.</summary>
    public void Average(int cells, int lines)
    {
        for (int cell = 0; cell < cells; cell++)
        {
            Bright[cell] /= lines;
            Blue[cell] /= lines;
        }
    }

    /// <summary>
    /// Adds the pixels of one line. Between knots the ground is straight, so that the point in the camera's frame is linear in the distance
    /// along the line: P(o) = P0 + (P1 - P0) (o - o0) / (o1 - o0).
    /// </summary>
    /// <param name="image">The image.</param>
    /// <param name="placeAt">The place at a distance, at the height of the road network; metres.</param>
    /// <param name="from">The distance at which the first cell begins.</param>
    /// <param name="cells">Number of cells.</param>
    public void Add(PaintImage image, Func<double, Vector3D> placeAt, double from, int cells)
    {
        int perKnot = (int)(KnotStep / StripeFinder.Cell);
        Vector3D? before = Knot(image, placeAt(from));
        for (int first = 0; first < cells; first += perKnot)
        {
            Vector3D? after = Knot(image, placeAt(from + ((first + perKnot) * StripeFinder.Cell)));
            if (before is { } a && after is { } b)
            {
                Vector3D step = (b - a) / perKnot;
                int last = Math.Min(cells, first + perKnot);
                for (int cell = first; cell < last; cell++)
                {
                    AddPixel(image, a + (step * (cell - first + 0.5)), cell);
                }
            }

            before = after;
        }
    }

    /// <summary>The next cells, from a cell on, of which all lines were seen; empty at the end.</summary>
    public (int Begin, int End) NextSeen(int from, int cells, int lines)
    {
        int begin = from;
        while (begin < cells && Count[begin] < lines)
        {
            begin++;
        }

        int end = begin;
        while (end < cells && Count[end] == lines)
        {
            end++;
        }

        return (begin, end);
    }

    /// <summary>The ground at a place in the camera's frame; null if its height is unknown.</summary>
    private static Vector3D? Knot(PaintImage image, Vector3D place)
    {
        double height = image.Ground.HeightAt(place);
        return double.IsNaN(height) ? null : image.Camera.Pose.ToLocal(place with { Z = height });
    }

    private void AddPixel(PaintImage image, Vector3D place, int cell)
    {
        if (place.Y < MinDepth || place.Y > MaxDepth)
        {
            return;
        }

        Vector2D pixel = image.Camera.PixelOf(place);
        double x = pixel.X - 0.5;
        double y = pixel.Y - 0.5;
        int width = image.Camera.Image.Width;
        if (!(x >= 0 && y >= 0 && x < width - 1 && y < image.Camera.Image.Height - 1))
        {
            return;
        }

        int column = (int)x;
        int row = (int)y;
        int at = (row * width) + column;
        if (image.Hidden is { } hidden && (hidden[at] | hidden[at + 1] | hidden[at + width] | hidden[at + width + 1]) != 0)
        {
            return;
        }

        if (image.Depths is { } depths && depths[at] > 0 && depths[at] < place.Y * (1 - DepthTolerance))
        {
            return;
        }

        // Bilinear interpolation between the four pixels around the point.
        float right = (float)(x - column);
        float down = (float)(y - row);
        byte[] rgb = image.Rgb;
        int upper = 3 * at;
        int lower = upper + (3 * width);
        float upperLeft = (1 - right) * (1 - down);
        float upperRight = right * (1 - down);
        float lowerLeft = (1 - right) * down;
        float lowerRight = right * down;
        Bright[cell] +=
            0.5f
            * (
                (upperLeft * (rgb[upper] + rgb[upper + 1]))
                + (upperRight * (rgb[upper + 3] + rgb[upper + 4]))
                + (lowerLeft * (rgb[lower] + rgb[lower + 1]))
                + (lowerRight * (rgb[lower + 3] + rgb[lower + 4]))
            );
        Blue[cell] +=
            (upperLeft * rgb[upper + 2]) + (upperRight * rgb[upper + 5]) + (lowerLeft * rgb[lower + 2]) + (lowerRight * rgb[lower + 5]);
        Count[cell]++;
    }
}
