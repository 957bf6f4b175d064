using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// The variance of each pixel between equal pictures, pooled over the pixels around it. Which pictures show the same differs from pixel to
/// pixel, but of two bits of a code word either the pictures without the bits' objects show the same, or successive pictures do. So of the
/// differences between pictures one or two apart, one of the smallest is taken. The first and the last picture, which both show
/// everything, are compared too.
/// </summary>
internal sealed class NoiseMap
{
    /// <summary>Differences are pooled over this many rows and columns on each side.</summary>
    private const int Reach = 2;

    /// <summary>Minimum variance: six times the 1/12 of rounding to whole grey levels.</summary>
    private const double MinVariance = 0.5;

    /// <summary>
    /// The difference that is taken, counted from the smallest, and how large it is in units of twice the variance: between the quantiles
    /// of the chi-squared distribution of three degrees of freedom for 6 equal pairs (2.0) and for 29 (0.5).
    /// </summary>
    private const int Rank = 2;
    private const float RankQuantile = 1.2f;
    private const int MaxStep = 2;

    /// <summary>A difference between the first and the last picture above this many grey levels is not noise: something moved.</summary>
    private const float MaxDifference = 40;

    private readonly float[] _variances;

    public NoiseMap(IReadOnlyList<byte[]> pictures, ImageSize image)
    {
        int width = image.Width;
        int height = image.Height;
        var rows = new float[image.PixelCount];
        _variances = new float[image.PixelCount];
        var least = new float[Rank + 1];
        for (int row = 0; row < height; row++)
        {
            float sum = 0;
            var queue = new float[(2 * Reach) + 1];
            for (int column = -Reach; column < width; column++)
            {
                int next = column + Reach;
                int slot = (next + queue.Length) % queue.Length;
                float value = next < width ? VarianceAt(pictures, (row * width) + next, least) : 0;

                // Running sum over the columns within Reach: the value that enters replaces the one that leaves; outside the image both are
                // 0.
                sum += value - queue[slot];
                queue[slot] = value;
                if (column >= 0)
                {
                    rows[(row * width) + column] = sum / (Math.Min(width - 1, next) - Math.Max(0, column - Reach) + 1);
                }
            }
        }

        for (int pixel = 0; pixel < rows.Length; pixel++)
        {
            // The same mean down the column of row means gives the mean over (2·Reach + 1)² pixels, fewer at the image's border.
            int row = pixel / width;
            int top = Math.Max(0, row - Reach);
            int bottom = Math.Min(height - 1, row + Reach);
            float sum = 0;
            for (int r = top; r <= bottom; r++)
            {
                sum += rows[(r * width) + (pixel % width)];
            }

            _variances[pixel] = (float)Math.Max(MinVariance, sum / (bottom - top + 1));
        }
    }

    /// <summary>The variance of a channel of a pixel, squared grey levels.</summary>
    public double At(int pixel) => _variances[pixel];

    private static float VarianceAt(IReadOnlyList<byte[]> pictures, int pixel, float[] least)
    {
        for (int i = 0; i <= Rank; i++)
        {
            least[i] = float.MaxValue;
        }

        for (int step = 1; step <= MaxStep; step++)
        {
            for (int picture = step; picture < pictures.Count - 1; picture++)
            {
                // Insertion keeps the Rank + 1 smallest differences, in ascending order.
                float squares = SquaresAt(pictures[picture - step], pictures[picture], pixel);
                for (int i = 0; i <= Rank; i++)
                {
                    if (squares < least[i])
                    {
                        (squares, least[i]) = (least[i], squares);
                    }
                }
            }
        }

        // The difference of two pictures has twice the variance v of one, so summed over three channels it is 2v times a chi-squared value
        // of three degrees of freedom. Its quantile gives v = squares / quantile / 2; of a single difference, whose mean is 3, squares / 6.
        float between = least[Rank] < float.MaxValue ? least[Rank] / RankQuantile / 2 : 0;
        float ends = SquaresAt(pictures[0], pictures[pictures.Count - 1], pixel);
        return Math.Max(between, ends <= 3 * MaxDifference * MaxDifference ? ends / 6 : 0);
    }

    private static float SquaresAt(byte[] first, byte[] second, int pixel)
    {
        float squares = 0;
        for (int i = 3 * pixel; i < (3 * pixel) + 3; i++)
        {
            float difference = first[i] - second[i];
            squares += difference * difference;
        }

        return squares;
    }
}
