namespace Harvester.Datasets.Exports.Formats.Kitti;

/// <summary>Decimals of KITTI's files: more than the two of the originals, so that nothing is lost.</summary>
internal static class KittiDecimals
{
    public const int Angle = 4;
    public const int Pixels = 2;
    public const int Metres = 3;
    public const int Fraction = 2;
    public const int Calibration = 6;
}
