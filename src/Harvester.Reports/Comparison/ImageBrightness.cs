using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Reports.Comparison;

/// <summary>The brightness of images.</summary>
public static class ImageBrightness
{
    /// <summary>Images of a dataset that are read, at most.</summary>
    public const int MaxImages = 200;

    private const double Red = 0.299;
    private const double Green = 0.587;
    private const double Blue = 0.114;

    /// <summary>The mean luma of each image, 0 to 255.</summary>
    /// <param name="paths">The images.</param>
    /// <exception cref="DatasetFormatException">An image is damaged.</exception>
    public static IEnumerable<double> Of(IEnumerable<string> paths) =>
        ReadAhead.Select(
            paths,
            path =>
            {
                try
                {
                    return MeanLuma(PictureReader.Read(path));
                }
                catch (DatasetFormatException e)
                {
                    throw new DatasetFormatException($"'{path}' cannot be read: {e.Message}", e);
                }
            }
        );

    /// <summary>The mean luma of a picture by Recommendation ITU-R BT.601, 0 to 255.</summary>
    public static double MeanLuma(PixelBuffer picture)
    {
        ArgumentNullException.ThrowIfNull(picture);
        long[] sums = new long[PixelBuffer.BytesPerPixel];
        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            sums[i % PixelBuffer.BytesPerPixel] += picture.Bytes[i];
        }

        return sums.Zip(ChannelWeights, (sum, weight) => sum * weight).Sum() / picture.Size.PixelCount;
    }

    private static IEnumerable<double> ChannelWeights => [Red, Green, Blue];
}
