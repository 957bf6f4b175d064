namespace Harvester.Geometry.Motion;

/// <summary>The numbers of 16 bits in maps of flow and of motion. A pixel without a value is 0, 0, 0.</summary>
public static class FlowUnits
{
    /// <summary>Numbers per pixel of flow, as in KITTI.</summary>
    public const double PerPixel = 64;

    /// <summary>Numbers per metre of motion: a millimetre.</summary>
    public const double PerMetre = 1000;

    /// <summary>The number of no flow or motion.</summary>
    public const int Zero = 32768;

    /// <summary>Motion of at least so many metres along an axis cannot be written.</summary>
    public const double MaxMetres = 32.766;

    /// <summary>The number of a flow along one axis, pixels; at most <see cref="FlowMaker.MaxPixels"/> to either side.</summary>
    public static ushort OfPixels(double pixels) => (ushort)Math.Round(Zero + (pixels * PerPixel));

    /// <summary>The flow of a number, pixels.</summary>
    public static double PixelsOf(ushort number) => (number - Zero) / PerPixel;

    /// <summary>The number of a motion along one axis, metres; at most <see cref="MaxMetres"/> to either side.</summary>
    public static ushort OfMetres(double metres) => (ushort)Math.Round(Zero + (metres * PerMetre));

    /// <summary>The motion of a number, metres.</summary>
    public static double MetresOf(ushort number) => (number - Zero) / PerMetre;

    /// <summary>Whether a motion can be written.</summary>
    public static bool IsMetres(double metres) => Math.Abs(metres) <= MaxMetres;
}
