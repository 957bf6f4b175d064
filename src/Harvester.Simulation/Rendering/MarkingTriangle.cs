using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A triangle of a road marking in the pinhole image. It covers a part of each pixel near it, so that a line thinner than a pixel fades
/// instead of breaking into dots.
/// </summary>
internal readonly struct MarkingTriangle
{
    /// <summary>How far from the centre of a pixel, along an axis of the image, an edge still cuts it, pixels.</summary>
    public const double Reach = 0.5;

    private readonly Vector256<double> _x;
    private readonly Vector256<double> _y;
    private readonly Vector256<double> _w;
    private readonly double _slopeX;
    private readonly double _slopeY;
    private readonly double _atOrigin;

    /// <param name="a">First corner: pixels, near / depth.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="doubleArea">Twice the area in square pixels, positive where the corners run clockwise on the screen; not 0.</param>
    /// <param name="pixels">The pixels that it may cover a part of.</param>
    /// <param name="colour">Its colour in white light.</param>
    public MarkingTriangle(
        Vector256<double> a,
        Vector256<double> b,
        Vector256<double> c,
        double doubleArea,
        PixelRectangle pixels,
        Rgb colour
    )
    {
        double sign = Math.Sign(doubleArea);
        Vector256<double> x = sign * Vector256.Create(a[1] - b[1], b[1] - c[1], c[1] - a[1], 0);
        Vector256<double> y = sign * Vector256.Create(b[0] - a[0], c[0] - b[0], a[0] - c[0], 0);
        Vector256<double> w =
            sign * Vector256.Create((a[0] * b[1]) - (a[1] * b[0]), (b[0] * c[1]) - (b[1] * c[0]), (c[0] * a[1]) - (c[1] * a[0]), 0);

        // Distances are counted along the axis of the image that an edge crosses more directly: across a line, the pixels of a row or
        // column then add up to the line's width.
        Vector256<double> length = Vector256.MaxNative(Vector256.Abs(x), Vector256.Abs(y)).WithElement(3, 1);
        (_x, _y) = (x / length, y / length);

        // The fourth edge is far from everything.
        _w = (w / length).WithElement(3, 1);
        _slopeX = (((b[2] - a[2]) * (c[1] - a[1])) - ((c[2] - a[2]) * (b[1] - a[1]))) / doubleArea;
        _slopeY = (((c[2] - a[2]) * (b[0] - a[0])) - ((b[2] - a[2]) * (c[0] - a[0]))) / doubleArea;
        _atOrigin = a[2] - (_slopeX * a[0]) - (_slopeY * a[1]);
        Pixels = pixels;
        Colour = colour;
    }

    public PixelRectangle Pixels { get; }

    public Rgb Colour { get; }

    /// <summary>The near plane's distance divided by the depth at a place of the image.</summary>
    public double NearnessAt(double x, double y) => (_slopeX * x) + (_slopeY * y) + _atOrigin;

    /// <summary>
    /// The greatest nearness of its plane in a rectangle of the image. A pixel that the triangle covers in part may show nearer ground than
    /// any of its corners.
    /// </summary>
    /// <param name="min">The rectangle's least x and y.</param>
    /// <param name="max">Its greatest x and y.</param>
    public double MaxNearness(Vector256<double> min, Vector256<double> max) =>
        NearnessAt(_slopeX > 0 ? max[0] : min[0], _slopeY > 0 ? max[1] : min[1]);

    /// <summary>
    /// The fraction of a pixel that is covered, as far as the edges can be looked at one by one. Triangles that share an edge share the
    /// pixels along it without gap or overlap.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double CoverageAt(double x, double y)
    {
        // Each edge leaves the fraction of the pixel that lies on its inner side, its distance from the centre plus ½. What three edges
        // leave out adds up: 1 - Σ (1 - inside), and the fourth edge leaves 1.
        Vector256<double> inside = (_x * x) + (_y * y) + _w + Vector256.Create(Reach);
        inside = Vector256.MinNative(Vector256.MaxNative(inside, Vector256<double>.Zero), Vector256<double>.One);
        return Math.Max(0, Vector256.Sum(inside) - 3);
    }

    /// <summary>The columns of a row, of those given, that no edge leaves out.</summary>
    public (int Left, int Right) ColumnsNear(double y, int left, int right)
    {
        Vector256<double> atZero = (_y * y) + _w + Vector256.Create(Reach);
        double low = left;
        double high = right;
        for (int edge = 0; edge < 3; edge++)
        {
            double slope = _x[edge];
            double crossing = -atZero[edge] / slope;
            if (slope > 0)
            {
                low = Math.Max(low, Math.Floor(crossing - Reach));
            }
            else if (slope < 0)
            {
                high = Math.Min(high, Math.Ceiling(crossing + Reach));
            }
            else if (atZero[edge] <= 0)
            {
                return (left, left);
            }
        }

        return ((int)low, (int)high);
    }
}
