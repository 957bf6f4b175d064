using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Looks for stripes in images. Around each image the ground is unrolled along the links of the road network, row by row across the road;
/// each row is a profile of brightness over the offset, in which a <see cref="StripeFinder"/> finds the stripes. Use one scanner per
/// thread.
/// </summary>
public sealed class PaintScanner
{
    /// <summary>
    /// Farthest row that is scanned, metres from the camera: beyond it, the height of the ground is not known well enough.
    /// </summary>
    public const double MaxDistance = 30;

    /// <summary>Nearest depth of ground, metres.</summary>
    private const double MinDepth = 0.5;

    /// <summary>Widest pixel across the road, metres: two of them are the narrowest paint.</summary>
    private const double MaxPixelAcross = 0.05;

    /// <summary>Longest pixel along the road, metres: longer ones blur dashes into their gaps.</summary>
    private const double MaxPixelAlong = 1.2;

    /// <summary>What is nearer than the ground by this fraction stands on it: 1 m in 20, the length of road behind 8 cm of
    /// height.</summary>
    private const double DepthTolerance = 0.05;

    /// <summary>Distance between places of a row at which the height of the ground is taken, metres.</summary>
    private const double KnotStep = 1;

    /// <summary>Profiles that are averaged for a row: a single one has the noise of single pixels.</summary>
    private const int ProfilesPerRow = 3;

    /// <summary>Standard deviation of the position of an edge, pixels.</summary>
    private const double EdgeSigma = 0.3;

    /// <summary>Ground where offsets are less sure than this is not searched, metres: a twelfth of the narrowest lane.</summary>
    private const double MaxSigma = 0.25;

    /// <summary>
    /// Ground seen beside a stripe on both sides, metres: the other stripe of a double line is no farther away, so that of a double line
    /// both stripes are seen or neither.
    /// </summary>
    private const double Margin = 0.6;

    private readonly PaintRoads _roads;
    private readonly StripeFinder _finder = new();
    private readonly List<StripeFinder.Stripe> _stripes = [];
    private float[] _bright = [];
    private float[] _blue = [];
    private int[] _count = [];

    /// <summary>Creates a scanner.</summary>
    /// <param name="roads">The roads.</param>
    public PaintScanner(PaintRoads roads) => _roads = Guard.NotNull(roads, nameof(roads));

    /// <summary>Scans an image.</summary>
    /// <param name="image">The image.</param>
    /// <param name="number">Number of the image, which its stripes keep.</param>
    /// <param name="evidence">Receives what is seen.</param>
    public void Scan(PaintImage image, int number, PaintEvidence evidence)
    {
        Guard.NotNull(image, nameof(image));
        Guard.NotNull(evidence, nameof(evidence));
        Vector3D camera = image.Camera.Pose.Position;
        foreach (int link in (IEnumerable<int>)_roads.Near(camera))
        {
            RoadCurve curve = _roads.Curves.Of(link);
            if (curve.IsBeyond(new Vector2D(camera.X, camera.Y), MaxDistance))
            {
                continue;
            }

            for (int row = 0; row < _roads.RowsOf(link); row++)
            {
                double station = _roads.StationOf(link, row);
                if (!_roads.Junctions.Contains(link, station))
                {
                    ScanRow(image, number, link, row, station, evidence);
                }
            }
        }
    }

    private void ScanRow(PaintImage image, int number, int link, int row, double station, PaintEvidence evidence)
    {
        RoadCurve curve = _roads.Curves.Of(link);
        double parameter = curve.ParameterAt(station);
        Vector3D centre = curve.PointAt(parameter);
        Vector3D from = image.Camera.Pose.Position;
        (double x, double y) = (centre.X - from.X, centre.Y - from.Y);
        double ground = Math.Sqrt((x * x) + (y * y));
        if (ground > MaxDistance)
        {
            return;
        }

        // Distance of the camera from the plane of the road in this row, which has the slope of the link's line.
        Vector2D direction = curve.DirectionAt(parameter);
        double slope = curve.Slope;
        double level = image.Ground.HeightAt(centre);
        double rise = (double.IsNaN(level) ? centre.Z : level) - from.Z;
        double height = ((((x * direction.X) + (y * direction.Y)) * slope) - rise) / Math.Sqrt(1 + (slope * slope));
        double distance = Math.Sqrt((ground * ground) + (rise * rise));
        double focal = image.Camera.Intrinsics.Fx;

        // A pixel covers d / f metres across the line of sight, and d / h times as much along it on the ground.
        double across = distance / focal;
        double along = across * distance / Math.Max(0.1, height);
        if (height <= 0 || across > MaxPixelAcross || along > MaxPixelAlong)
        {
            return;
        }

        (float left, float right) = _roads.ReachAt(link, station);
        int cells = (int)((right - left) / StripeFinder.Cell);
        Reserve(cells);
        for (int i = 0; i < ProfilesPerRow; i++)
        {
            double shift = (((i + 0.5) / ProfilesPerRow) - 0.5) * PaintRow.Length;
            AddProfile(image, curve, curve.ParameterAt(station + shift), left, cells);
        }

        for (int cell = 0; cell < cells; cell++)
        {
            _bright[cell] /= ProfilesPerRow;
            _blue[cell] /= ProfilesPerRow;
        }

        double cameraOffset = -((x * direction.Y) - (y * direction.X));
        var seen = new SeenSpan(
            number,
            0,
            0,
            (float)cameraOffset,
            (float)(EdgeSigma * across),
            (float)(image.Ground.SigmaAt(ground) / height)
        );
        for (int cell = 0; cell < cells; cell++)
        {
            if (seen.SigmaAt(left + (cell * StripeFinder.Cell)) > MaxSigma)
            {
                _count[cell] = 0;
            }
        }

        for (int begin = 0; begin < cells; begin++)
        {
            if (_count[begin] < ProfilesPerRow)
            {
                continue;
            }

            int end = begin;
            while (end < cells && _count[end] == ProfilesPerRow)
            {
                end++;
            }

            AddRun(link, row, left, begin, end, seen, evidence);
            begin = end;
        }
    }

    private void AddRun(int link, int row, float left, int begin, int end, SeenSpan seen, PaintEvidence evidence)
    {
        double OffsetOf(double cell) => left + (cell * StripeFinder.Cell);
        float first = (float)(OffsetOf(begin) + Margin);
        float last = (float)(OffsetOf(end) - Margin);
        if (first >= last)
        {
            return;
        }

        _stripes.Clear();
        _finder.Find(_bright, _blue, begin, end, _stripes);
        evidence.Add(link, row, seen with { Left = first, Right = last });
        foreach (StripeFinder.Stripe stripe in _stripes)
        {
            float middle = (float)OffsetOf((stripe.Left + stripe.Right) / 2);
            if (middle >= first && middle <= last)
            {
                float width = (float)((stripe.Right - stripe.Left) * StripeFinder.Cell);
                float sigma = (float)seen.SigmaAt(middle);
                evidence.Add(
                    link,
                    row,
                    new PaintCandidate(seen.Image, middle, width, (float)stripe.Contrast, (float)stripe.Blueness, sigma)
                );
            }
        }
    }

    /// <summary>
    /// Adds the pixels of one line across the road. Between knots the ground is straight, so that the point in the camera's frame is linear
    /// in the offset: P(o) = P0 + (P1 - P0) (o - o0) / (o1 - o0).
    /// </summary>
    private void AddProfile(PaintImage image, RoadCurve curve, double parameter, float left, int cells)
    {
        int perKnot = (int)(KnotStep / StripeFinder.Cell);
        Vector3D? before = Knot(image, curve, parameter, left);
        for (int first = 0; first < cells; first += perKnot)
        {
            Vector3D? after = Knot(image, curve, parameter, left + ((first + perKnot) * StripeFinder.Cell));
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

    /// <summary>The ground at an offset in the camera's frame; null if its height is unknown.</summary>
    private static Vector3D? Knot(PaintImage image, RoadCurve curve, double parameter, double offset)
    {
        Vector3D place = curve.PointBeside(parameter, offset);
        double height = image.Ground.HeightAt(place);
        return double.IsNaN(height) ? null : image.Camera.Pose.ToLocal(place with { Z = height });
    }

    private void AddPixel(PaintImage image, Vector3D place, int cell)
    {
        if (place.Y < MinDepth)
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
        _bright[cell] +=
            0.5f
            * (
                (upperLeft * (rgb[upper] + rgb[upper + 1]))
                + (upperRight * (rgb[upper + 3] + rgb[upper + 4]))
                + (lowerLeft * (rgb[lower] + rgb[lower + 1]))
                + (lowerRight * (rgb[lower + 3] + rgb[lower + 4]))
            );
        _blue[cell] +=
            (upperLeft * rgb[upper + 2]) + (upperRight * rgb[upper + 5]) + (lowerLeft * rgb[lower + 2]) + (lowerRight * rgb[lower + 5]);
        _count[cell]++;
    }

    private void Reserve(int cells)
    {
        if (_bright.Length < cells)
        {
            _bright = new float[cells];
            _blue = new float[cells];
            _count = new int[cells];
        }

        Array.Clear(_bright, 0, cells);
        Array.Clear(_blue, 0, cells);
        Array.Clear(_count, 0, cells);
    }
}
