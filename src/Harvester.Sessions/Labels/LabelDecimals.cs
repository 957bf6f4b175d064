namespace Harvester.Sessions.Labels;

/// <summary>How many decimals the numbers of a session's files have, by what they measure.</summary>
internal static class LabelDecimals
{
    /// <summary>A tenth of a millimetre.</summary>
    public const int Metres = 4;

    /// <summary>Metres per second.</summary>
    public const int Speed = 4;

    /// <summary>A thousandth of a pixel.</summary>
    public const int Pixels = 3;

    /// <summary>Shares of something.</summary>
    public const int Fraction = 4;

    /// <summary>Components of unit vectors: an error of a micrometre at 1 km.</summary>
    public const int Axis = 9;

    /// <summary>Focal lengths and principal points, pixels.</summary>
    public const int Intrinsics = 6;

    /// <summary>Angles in degrees.</summary>
    public const int Degrees = 4;

    /// <summary>The field of view, degrees, and ratios that enter every pixel's place.</summary>
    public const int CameraRatio = 9;

    /// <summary>A microsecond.</summary>
    public const int Seconds = 6;
}
