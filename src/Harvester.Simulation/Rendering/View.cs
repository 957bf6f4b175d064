using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A camera prepared for drawing: its matrix, the sides of its frustum, and the pixels that a rectangle of the pinhole image can reach.
/// </summary>
internal sealed class View
{
    /// <summary>How many sides a view has, the near plane included.</summary>
    public const int SideCount = 5;

    private readonly double _left;
    private readonly double _top;
    private readonly double _right;
    private readonly double _bottom;
    private readonly Vector256<double> _size;

    public View(RenderCamera camera, SampleGrid? grid)
    {
        Camera = camera;
        Grid = grid;
        Matrix = camera.ViewProjection;
        _size = Vector256.Create(camera.Width, camera.Height, camera.Width, (double)camera.Height);
        (_left, _right) = Range(grid?.U, camera.Width);
        (_top, _bottom) = Range(grid?.V, camera.Height);
    }

    public RenderCamera Camera { get; }

    /// <summary>The sample positions of a distorting lens; null for a lens that keeps lines straight.</summary>
    public SampleGrid? Grid { get; }

    public Matrix4 Matrix { get; }

    /// <summary>Writes the sides of the view in the frame that a matrix to clip space starts from.</summary>
    public void WriteSides(in Matrix4 toClip, Span<Plane> sides)
    {
        // In clip space a point is inside where left · w ≤ x ≤ right · w, top · w ≤ y ≤ bottom · w and w ≥ near; each is a plane in the
        // frame from which the matrix starts.
        sides[4] = Side(toClip.Row3, new Vector4(0, 0, 0, -Camera.NearClip));
        sides[3] = Side(toClip.Row3 * _bottom, toClip.Row1 * -1);
        sides[2] = Side(toClip.Row1, toClip.Row3 * -_top);
        sides[1] = Side(toClip.Row3 * _right, toClip.Row0 * -1);
        sides[0] = Side(toClip.Row0, toClip.Row3 * -_left);
    }

    /// <summary>Distance of the near plane, metres.</summary>
    public double NearClip => Camera.NearClip;

    /// <summary>
    /// The pixels whose centres may lie in a rectangle of the pinhole image; x and y are the first two elements of its corners.
    /// </summary>
    public PixelRectangle PixelsIn(Vector256<double> min, Vector256<double> max)
    {
        if (Grid is not null)
        {
            return PixelsIn(min[0], min[1], max[0], max[1]);
        }

        Vector256<double> sides = Vector256.Create(min.GetLower(), max.GetLower());
        sides = Vector256.Ceiling(sides - Vector256.Create(0.5));
        sides = Vector256.MinNative(Vector256.MaxNative(sides, Vector256<double>.Zero), _size);
        return new PixelRectangle((int)sides[0], (int)sides[1], (int)sides[2], (int)sides[3]);
    }

    /// <summary>The pixels whose centres may lie in a rectangle of the pinhole image.</summary>
    public PixelRectangle PixelsIn(double left, double top, double right, double bottom)
    {
        if (Grid is not null)
        {
            // Enlarged by interval arithmetic: every point of the rectangle is scaled about the centre by some factor of the range.
            (double least, double greatest) = FactorsIn(left, top, right, bottom);
            (left, right) = Scale(left, right, Camera.CentreX, least, greatest);
            (top, bottom) = Scale(top, bottom, Camera.CentreY, least, greatest);
        }

        return new PixelRectangle(
            (int)Math.Clamp(Math.Ceiling(left - 0.5), 0, Camera.Width),
            (int)Math.Clamp(Math.Ceiling(top - 0.5), 0, Camera.Height),
            (int)Math.Clamp(Math.Ceiling(right - 0.5) + (Grid is null ? 0 : 1), 0, Camera.Width),
            (int)Math.Clamp(Math.Ceiling(bottom - 0.5) + (Grid is null ? 0 : 1), 0, Camera.Height)
        );
    }

    /// <summary>The position of a pixel's centre in the pinhole image.</summary>
    public Vector2D SampleAt(int column, int row) =>
        Grid is null
            ? new Vector2D(column + 0.5, row + 0.5)
            : new Vector2D(Grid.U[(row * Camera.Width) + column], Grid.V[(row * Camera.Width) + column]);

    private (double Least, double Greatest) FactorsIn(double left, double top, double right, double bottom)
    {
        (double nearX, double farX) = Distances((left - Camera.CentreX) / Camera.FocalX, (right - Camera.CentreX) / Camera.FocalX);
        (double nearY, double farY) = Distances((top - Camera.CentreY) / Camera.FocalY, (bottom - Camera.CentreY) / Camera.FocalY);
        return Grid!.FactorsBetween(Math.Sqrt((nearX * nearX) + (nearY * nearY)), Math.Sqrt((farX * farX) + (farY * farY)));
    }

    private static (double Near, double Far) Distances(double low, double high) =>
        (Math.Max(0, Math.Max(low, -high)), Math.Max(Math.Abs(low), Math.Abs(high)));

    private static (double Low, double High) Scale(double low, double high, double centre, double least, double greatest)
    {
        double a = low - centre;
        double b = high - centre;
        return (centre + Math.Min(a * least, a * greatest), centre + Math.Max(b * least, b * greatest));
    }

    private static (double Low, double High) Range(double[]? values, int size)
    {
        double low = 0;
        double high = size;
        foreach (double value in values ?? [])
        {
            low = Math.Min(low, value - 1);
            high = Math.Max(high, value + 1);
        }

        return (low, high);
    }

    private static Plane Side(Vector4 a, Vector4 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z, a.W + b.W);
}
