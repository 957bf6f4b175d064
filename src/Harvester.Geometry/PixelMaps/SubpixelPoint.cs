namespace Harvester.Geometry.PixelMaps;

/// <summary>A point of the image through which a ray can be cast, in eighths of a pixel from the centre of pixel (0, 0).</summary>
internal readonly record struct SubpixelPoint(int FineX, int FineY)
{
    public static SubpixelPoint OfPixel(int column, int row) => new(column * PixelSamples.Fine, row * PixelSamples.Fine);
}
