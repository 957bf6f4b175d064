namespace Harvester.Geometry.PixelMaps;

/// <summary>A place of the image that a ray can go through, in eighths of a pixel from the centre of the pixel (0, 0).</summary>
internal readonly record struct Place(int FineX, int FineY)
{
    public static Place OfPixel(int column, int row) => new(column * PixelSamples.Fine, row * PixelSamples.Fine);
}
