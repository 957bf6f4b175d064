using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// The square of the world that a shadow map covers, seen along parallel rays of light. Texel (i, j) reaches from (i, j) to (i + 1, j + 1)
/// in texels along <see cref="Across"/> and <see cref="Along"/>.
/// </summary>
/// <param name="Light">Unit vector towards the light.</param>
/// <param name="Across">Unit vector of the map's columns, square to the light.</param>
/// <param name="Along">Unit vector of the map's rows, square to both.</param>
/// <param name="Left">Where the first column begins along <see cref="Across"/>, metres from the world's origin.</param>
/// <param name="Bottom">Where the first row begins along <see cref="Along"/>, metres from the world's origin.</param>
/// <param name="Zero">Where heights towards the light are counted from, metres from the world's origin.</param>
/// <param name="TexelMetres">Side of a texel.</param>
/// <param name="Size">Rows and columns.</param>
internal readonly record struct ShadowFrame(
    Vector3D Light,
    Vector3D Across,
    Vector3D Along,
    double Left,
    double Bottom,
    double Zero,
    double TexelMetres,
    int Size
)
{
    /// <summary>A frame moves by this fraction of its side at a time, so that its map need not be drawn for every picture.</summary>
    private const double SnapFraction = 1.0 / 8;

    /// <summary>Above this slope of the light, x cannot be mistaken for the light's own direction.</summary>
    private const double Steep = 0.99;

    /// <summary>A frame around a place, which lies within a sixteenth of the frame's side from its centre.</summary>
    public static ShadowFrame Around(Vector3D light, Vector3D place, double texelMetres, int size)
    {
        Vector3D reference = light.Z > Steep ? new Vector3D(0, 1, 0) : new Vector3D(0, 0, 1);
        Vector3D across = reference.Cross(light).Normalized();
        Vector3D along = light.Cross(across);
        double side = texelMetres * size;
        double step = side * SnapFraction;
        return new ShadowFrame(
            light,
            across,
            along,
            (Math.Round(across.Dot(place) / step) * step) - (side / 2),
            (Math.Round(along.Dot(place) / step) * step) - (side / 2),
            Math.Round(light.Dot(place) / step) * step,
            texelMetres,
            size
        );
    }

    /// <summary>World coordinates to texels across and along, and metres towards the light.</summary>
    public Matrix4 FromWorld =>
        new(Row(Across, Left, 1 / TexelMetres), Row(Along, Bottom, 1 / TexelMetres), Row(Light, Zero, 1), new Vector4(0, 0, 0, 1));

    /// <summary>Writes the four sides of the frame, as planes of the world.</summary>
    public void WriteSides(Span<Plane> sides)
    {
        double side = TexelMetres * Size;
        sides[0] = new Plane(Across.X, Across.Y, Across.Z, -Left);
        sides[1] = new Plane(-Across.X, -Across.Y, -Across.Z, Left + side);
        sides[2] = new Plane(Along.X, Along.Y, Along.Z, -Bottom);
        sides[3] = new Plane(-Along.X, -Along.Y, -Along.Z, Bottom + side);
    }

    private static Vector4 Row(Vector3D axis, double start, double scale) => new Vector4(axis.X, axis.Y, axis.Z, -start) * scale;
}
