namespace Harvester.Sessions.Labels;

/// <summary>Number of decimals in a session's files, by quantity.</summary>
internal static class LabelDecimals
{
    /// <summary>Metres, to 0.1 mm.</summary>
    public const int Metres = 4;

    /// <summary>Decimals of speeds, m/s: 0.1 mm/s.</summary>
    public const int Speed = 4;

    /// <summary>Pixels, to 0.001 px.</summary>
    public const int Pixels = 3;

    /// <summary>Decimals of fractions, 0 to 1.</summary>
    public const int Fraction = 4;

    /// <summary>Components of unit vectors: an error of a micrometre at 1 km.</summary>
    public const int Axis = 9;

    /// <summary>Focal lengths and principal points, pixels.</summary>
    public const int Intrinsics = 6;

    /// <summary>Decimals of angles, degrees.</summary>
    public const int Degrees = 4;

    /// <summary>The field of view, degrees, and ratios that affect every pixel position.</summary>
    public const int CameraRatio = 9;

    /// <summary>Seconds, to a microsecond.</summary>
    public const int Seconds = 6;
}
