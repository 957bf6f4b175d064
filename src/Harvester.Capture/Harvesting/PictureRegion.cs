using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Harvesting;

/// <summary>A part of a picture, by the pixels that were found in it.</summary>
/// <param name="XMin">Leftmost column.</param>
/// <param name="YMin">Uppermost row.</param>
/// <param name="XMax">Rightmost column.</param>
/// <param name="YMax">Lowest row.</param>
/// <param name="Image">Size of the picture, pixels.</param>
internal sealed record PictureRegion(int XMin, int YMin, int XMax, int YMax, ImageSize Image)
{
    /// <summary>The smallest region with all these pixels.</summary>
    /// <param name="pixels">Indices row by row; at least one.</param>
    /// <param name="image">Size of the picture.</param>
    public static PictureRegion Of(IReadOnlyCollection<int> pixels, ImageSize image) =>
        new(
            pixels.Min(pixel => pixel % image.Width),
            pixels.Min(pixel => pixel / image.Width),
            pixels.Max(pixel => pixel % image.Width),
            pixels.Max(pixel => pixel / image.Width),
            image
        );

    /// <summary>The part of the picture and its pixels, as text.</summary>
    public override string ToString()
    {
        string row = Third((YMin + YMax) / 2.0 / Image.Height, "upper", "middle", "lower");
        string column = Third((XMin + XMax) / 2.0 / Image.Width, "left", "middle", "right");
        string place = row == column ? "middle" : $"{row} {column}";
        return FormattableString.Invariant($"{place}, columns {XMin} to {XMax}, rows {YMin} to {YMax} of {Image.Width}x{Image.Height}");
    }

    private static string Third(double fraction, string first, string second, string third) =>
        fraction < 1.0 / 3 ? first
        : fraction < 2.0 / 3 ? second
        : third;
}
