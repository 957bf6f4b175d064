using System;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Files;

/// <summary>The size of a picture as its header declares it.</summary>
internal static class DeclaredSize
{
    /// <summary>More than any screen has, and few enough for one array.</summary>
    private const long MaxPixelCount = 1 << 29;

    /// <summary>Checks a size, pixels.</summary>
    /// <exception cref="DatasetFormatException">A side or the number of pixels is out of range.</exception>
    public static ImageSize Of(long width, long height) =>
        width is >= 1 and <= ushort.MaxValue && height is >= 1 and <= ushort.MaxValue && width * height <= MaxPixelCount
            ? new ImageSize((int)width, (int)height)
            : throw new DatasetFormatException(FormattableString.Invariant($"its header gives the impossible size {width} x {height}."));
}
