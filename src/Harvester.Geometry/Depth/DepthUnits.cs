namespace Harvester.Geometry.Depth;

/// <summary>The numbers of depth maps, as in KITTI: a 256th of a metre; 0 for no depth.</summary>
public static class DepthUnits
{
    /// <summary>Units per metre: a unit is 3.9 mm.</summary>
    public const double PerMetre = 256;

    /// <summary>The greatest depth that a map can hold, metres.</summary>
    public const double MaxMetres = ushort.MaxValue / PerMetre;

    /// <summary>The number of a depth; 0 if it is not positive or too great.</summary>
    public static ushort OfDepth(double metres) =>
        metres > 0 && metres <= MaxMetres ? (ushort)Math.Max(1, Math.Round(metres * PerMetre)) : (ushort)0;

    /// <summary>The number of an error: rounded up, at least 1, and the greatest number for an error beyond all.</summary>
    public static ushort OfError(double metres) =>
        metres < MaxMetres ? (ushort)Math.Max(1, Math.Ceiling(metres * PerMetre)) : ushort.MaxValue;
}
