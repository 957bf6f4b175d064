namespace Harvester.Exports.Formats.Kitti;

/// <summary>Decimals in KITTI's files: more than the two of the original, to keep the precision.</summary>
internal static class KittiDecimals
{
    public const int Angle = 4;
    public const int Pixels = 2;
    public const int Metres = 3;
    public const int Fraction = 2;
    public const int Calibration = 6;
}
