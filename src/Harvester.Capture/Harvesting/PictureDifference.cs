using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>The difference of two images.</summary>
internal static class PictureDifference
{
    /// <summary>Mean absolute difference of their bytes, 0 to 255.</summary>
    public static double MeanOf(PixelBuffer a, PixelBuffer b)
    {
        long sum = 0;
        for (int i = 0; i < a.Bytes.Length; i++)
        {
            sum += Math.Abs(a.Bytes[i] - b.Bytes[i]);
        }

        return (double)sum / a.Bytes.Length;
    }
}
