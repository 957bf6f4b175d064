using System.Numerics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A triangle in the pinhole's image: three edges whose value grows inward, the plane of near / depth over it, and its looks.
/// </summary>
internal readonly struct ScreenTriangle
{
    /// <param name="a">First corner: pixels, near / depth.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="doubleArea">Twice the area in square pixels, positive where the corners run clockwise on the screen; not 0.</param>
    /// <param name="pixels">The pixels that it may cover.</param>
    /// <param name="handle">The handle of what it belongs to.</param>
    /// <param name="source">The triangle that is shown.</param>
    /// <param name="normal">Unit vector of the world square to it, on the camera's side.</param>
    public ScreenTriangle(in Vector4 a, in Vector4 b, in Vector4 c, double doubleArea, PixelRectangle pixels, int handle,
        in MeshTriangle source, Vector3 normal)
    {
        // Edges of neighbours are the same numbers with opposite signs, to the last bit, so that no pixel falls between them.
        (Edge0, Edge1, Edge2) = doubleArea >= 0
            ? (new ScreenLine(a, b), new ScreenLine(b, c), new ScreenLine(c, a))
            : (new ScreenLine(b, a), new ScreenLine(c, b), new ScreenLine(a, c));
        double slopeX = (((b.Z - a.Z) * (c.Y - a.Y)) - ((c.Z - a.Z) * (b.Y - a.Y))) / doubleArea;
        double slopeY = (((c.Z - a.Z) * (b.X - a.X)) - ((b.Z - a.Z) * (c.X - a.X))) / doubleArea;
        Nearness = new ScreenLine(slopeX, slopeY, a.Z - (slopeX * a.X) - (slopeY * a.Y));
        Pixels = pixels;
        Handle = handle;
        Colour = source.Colour;
        Surface = source.Surface;
        Normal = normal;
    }

    public ScreenLine Edge0 { get; }

    public ScreenLine Edge1 { get; }

    public ScreenLine Edge2 { get; }

    /// <summary>The near plane's distance divided by the depth.</summary>
    public ScreenLine Nearness { get; }

    public PixelRectangle Pixels { get; }

    public int Handle { get; }

    public Rgb Colour { get; }

    public Surface Surface { get; }

    /// <summary>Unit vector of the world square to the triangle, on the camera's side.</summary>
    public Vector3 Normal { get; }
}
