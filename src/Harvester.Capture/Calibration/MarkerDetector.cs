using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Calibration;

/// <summary>
/// Finds the balls that one image shows and another of the same moment does not. A ball is a connected patch of changed pixels of about the
/// expected area that lies completely in the image. The fraction of a pixel that it covers follows from how far the pixel's colour has
/// moved towards the ball's own, so that the centre is accurate to a small fraction of a pixel on any background.
/// </summary>
internal sealed class MarkerDetector
{
    // Noise, drizzle and slow changes of light change a channel by less; a bright ball changes one by far more.
    private const int MinChange = 40;

    // Pixels that changed nearly as much as the most changed one are completely covered and show the ball's colour.
    private const double WholeFraction = 0.8;

    // A ball at the edge of a wide view is a narrow ellipse of a third of the area, before a lens shrinks it.
    private const double MinArea = 0.25;
    private const double MaxArea = 2.5;
    private readonly PixelBuffer _without;
    private readonly PixelBuffer _with;
    private readonly double _expectedArea;
    private readonly int _width;
    private readonly int _height;
    private readonly bool[] _isDone;

    private MarkerDetector(PixelBuffer without, PixelBuffer with, double radiusPixels)
    {
        _without = without;
        _with = with;
        _expectedArea = Math.PI * radiusPixels * radiusPixels;
        _width = with.Size.Width;
        _height = with.Size.Height;
        _isDone = new bool[with.Size.PixelCount];
    }

    /// <summary>Finds the balls in the difference of two pictures.</summary>
    /// <param name="without">The image without them.</param>
    /// <param name="with">The image with them, of the same size.</param>
    /// <param name="radiusPixels">Approximate radius of a ball, pixels.</param>
    public static IReadOnlyList<MarkerSpot> Find(PixelBuffer without, PixelBuffer with, double radiusPixels)
    {
        if (without.Size != with.Size)
        {
            throw new ArgumentException("Markers are found between pictures of one size.", nameof(with));
        }

        return new MarkerDetector(without, with, radiusPixels).Find();
    }

    private List<MarkerSpot> Find()
    {
        var spots = new List<MarkerSpot>();
        var patch = new List<int>();
        for (int pixel = 0; pixel < _isDone.Length; pixel++)
        {
            if (!_isDone[pixel] && Change(pixel) >= MinChange)
            {
                Collect(pixel, patch);
                if (SpotOf(patch) is { } spot)
                {
                    spots.Add(spot);
                }
            }
        }

        return spots;
    }

    /// <summary>The changed pixels that are connected with one, by their sides.</summary>
    private void Collect(int first, List<int> patch)
    {
        patch.Clear();
        Visit(first);
        for (int next = 0; next < patch.Count; next++)
        {
            int pixel = patch[next];
            int column = pixel % _width;
            if (column > 0)
            {
                Visit(pixel - 1);
            }

            if (column < _width - 1)
            {
                Visit(pixel + 1);
            }

            Visit(pixel - _width);
            Visit(pixel + _width);
        }

        void Visit(int pixel)
        {
            if (pixel >= 0 && pixel < _isDone.Length && !_isDone[pixel] && Change(pixel) >= MinChange)
            {
                _isDone[pixel] = true;
                patch.Add(pixel);
            }
        }
    }

    private MarkerSpot? SpotOf(List<int> patch)
    {
        if (patch.Count < MinArea * _expectedArea || patch.Count > MaxArea * _expectedArea)
        {
            return null;
        }

        int left = _width;
        int right = 0;
        foreach (int pixel in patch)
        {
            left = Math.Min(left, pixel % _width);
            right = Math.Max(right, pixel % _width);
        }

        // A patch is collected from its topmost row; one more pixel on each side includes those covered by less than the threshold.
        int top = (patch[0] / _width) - 1;
        int bottom = LowestRow(patch) + 1;
        left--;
        right++;
        return left < 0 || top < 0 || right >= _width || bottom >= _height ? null : CentreOf(left, top, right, bottom, ColourOf(patch));
    }

    private int LowestRow(List<int> patch)
    {
        int lowest = 0;
        foreach (int pixel in patch)
        {
            lowest = Math.Max(lowest, pixel / _width);
        }

        return lowest;
    }

    private MarkerSpot? CentreOf(int left, int top, int right, int bottom, Vector3D colour)
    {
        double area = 0;
        var moment = new Vector2D(0, 0);
        for (int y = top; y <= bottom; y++)
        {
            for (int x = left; x <= right; x++)
            {
                double covered = Covered((y * _width) + x, colour);
                area += covered;

                // The centre is the mean of the pixels' centres, weighted by how much of each the ball covers.
                moment += new Vector2D(x + 0.5, y + 0.5) * covered;
            }
        }

        return area > 0 ? new MarkerSpot(moment * (1 / area), area) : null;
    }

    /// <summary>The fraction of a pixel that a ball of a colour covers, 0 to 1.</summary>
    private double Covered(int pixel, Vector3D colour)
    {
        if (Change(pixel) == 0)
        {
            return 0;
        }

        Vector3D before = Colour(_without, pixel);

        // A pixel covered by the fraction f has the colour before + f·(ball - before); least squares give f.
        Vector3D whole = colour - before;
        double square = whole.LengthSquared;
        return square > 0 ? Math.Max(0, Math.Min(1, (Colour(_with, pixel) - before).Dot(whole) / square)) : 0;
    }

    private Vector3D ColourOf(List<int> patch)
    {
        int most = 0;
        foreach (int pixel in patch)
        {
            most = Math.Max(most, Change(pixel));
        }

        Vector3D sum = Vector3D.Zero;
        int count = 0;
        foreach (int pixel in patch)
        {
            if (Change(pixel) >= WholeFraction * most)
            {
                sum += Colour(_with, pixel);
                count++;
            }
        }

        return sum / count;
    }

    private int Change(int pixel)
    {
        int change = 0;
        for (int i = pixel * PixelBuffer.BytesPerPixel, end = i + PixelBuffer.BytesPerPixel; i < end; i++)
        {
            change = Math.Max(change, Math.Abs(_with.Bytes[i] - _without.Bytes[i]));
        }

        return change;
    }

    private static Vector3D Colour(PixelBuffer picture, int pixel)
    {
        int i = pixel * PixelBuffer.BytesPerPixel;
        return new Vector3D(picture.Bytes[i], picture.Bytes[i + 1], picture.Bytes[i + 2]);
    }
}
