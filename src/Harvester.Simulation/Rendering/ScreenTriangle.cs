using System.Numerics;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A triangle in the pinhole image: three edge functions that grow inward, the plane of near / depth over it, and its appearance.
/// </summary>
internal readonly struct ScreenTriangle
{
    private readonly double _slopeX;
    private readonly double _slopeY;
    private readonly double _atOrigin;

    /// <param name="a">First corner: pixels, near / depth.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="doubleArea">Twice the area in square pixels, positive where the corners run clockwise on the screen; not 0.</param>
    /// <param name="pixels">The pixels that it may cover.</param>
    /// <param name="handle">The handle of what it belongs to.</param>
    /// <param name="kind">What the surface of its mesh is.</param>
    /// <param name="source">The triangle that is shown.</param>
    /// <param name="normal">Unit vector of the world square to it, on the camera's side.</param>
    /// <param name="lanes">Where wheels run on it.</param>
    public ScreenTriangle(
        Vector256<double> a,
        Vector256<double> b,
        Vector256<double> c,
        double doubleArea,
        PixelRectangle pixels,
        int handle,
        SurfaceKind kind,
        in MeshTriangle source,
        Vector3 normal,
        in LanePlane lanes
    )
    {
        Edges = doubleArea >= 0 ? new EdgeTriple(a, b, c) : new EdgeTriple(b, a, c);

        // near / depth is linear in the image over a plane. Cramer's rule for its two slopes from the differences along two sides; the
        // determinant is twice the area.
        Vector256<double> ab = b - a;
        Vector256<double> ac = c - a;
        _slopeX = ((ab[2] * ac[1]) - (ac[2] * ab[1])) / doubleArea;
        _slopeY = ((ac[2] * ab[0]) - (ab[2] * ac[0])) / doubleArea;
        _atOrigin = a[2] - (_slopeX * a[0]) - (_slopeY * a[1]);
        Pixels = pixels;
        Handle = handle;
        Kind = kind;
        Colour = source.Colour;
        Surface = source.Surface;
        Normal = normal;
        Lanes = lanes;
    }

    public EdgeTriple Edges { get; }

    /// <summary>What a step to the right adds to the near plane's distance divided by the depth.</summary>
    public double NearnessStep => _slopeX;

    public PixelRectangle Pixels { get; }

    public int Handle { get; }

    public SurfaceKind Kind { get; }

    public Rgb Colour { get; }

    public Surface Surface { get; }

    /// <summary>Unit normal of the triangle in the world, on the camera's side.</summary>
    public Vector3 Normal { get; }

    /// <summary>Where wheels run on it.</summary>
    public LanePlane Lanes { get; }

    /// <summary>The near plane's distance divided by the depth at a place of the image.</summary>
    public double NearnessAt(double x, double y) => (_slopeX * x) + (_slopeY * y) + _atOrigin;
}
