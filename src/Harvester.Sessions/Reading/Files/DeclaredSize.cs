using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Reading.Files;

/// <summary>The size of an image as its header declares it.</summary>
internal static class DeclaredSize
{
    /// <summary>Largest number of pixels, that of the largest harvest, 8192 x 8192: a colour image takes 200 MB.</summary>
    private const long MaxPixelCount = 1 << 26;

    /// <summary>Checks a size, pixels.</summary>
    /// <exception cref="DatasetFormatException">A side or the number of pixels is out of range.</exception>
    public static ImageSize Of(long width, long height) =>
        Problem(width, height) is { } problem
            ? throw new DatasetFormatException($"its header gives {problem}.")
            : new ImageSize((int)width, (int)height);

    /// <summary>Why a size, pixels, is not valid for an image; null if it is.</summary>
    public static string? Problem(long width, long height) =>
        width is >= 1 and <= ushort.MaxValue && height is >= 1 and <= ushort.MaxValue && width * height <= MaxPixelCount
            ? null
            : FormattableString.Invariant($"the impossible size {width} x {height}");
}
