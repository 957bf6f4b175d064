using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>A picture reduced to the mean red, green and blue of its blocks.</summary>
internal sealed class BlockMeans
{
    private const int Columns = 16;
    private const int Rows = 12;
    private const int Channels = 3;

    /// <summary>Of independent values, second differences have a variance of 6, first ones of 2: the root of the ratio.</summary>
    private static readonly double SecondToFirst = Math.Sqrt(3);

    private readonly double[] _means;

    private BlockMeans(double[] means) => _means = means;

    /// <summary>Reduces a picture of any size; one of few pixels has blocks of one pixel.</summary>
    public static BlockMeans Of(PixelBuffer picture)
    {
        int columns = Math.Min(Columns, picture.Size.Width);
        int rows = Math.Min(Rows, picture.Size.Height);
        var sums = new int[columns * Channels];
        var means = new double[columns * rows * Channels];
        for (int block = 0; block < rows; block++)
        {
            int top = block * picture.Size.Height / rows;
            int bottom = (block + 1) * picture.Size.Height / rows;
            Array.Clear(sums, 0, sums.Length);
            for (int row = top; row < bottom; row++)
            {
                Add(picture, row, columns, sums);
            }

            for (int column = 0; column < columns; column++)
            {
                int width = ((column + 1) * picture.Size.Width / columns) - (column * picture.Size.Width / columns);
                for (int channel = 0; channel < Channels; channel++)
                {
                    int sum = sums[(column * Channels) + channel];
                    means[(((block * columns) + column) * Channels) + channel] = (double)sum / (width * (bottom - top));
                }
            }
        }

        return new BlockMeans(means);
    }

    /// <summary>The greatest and the mean absolute difference of the blocks of two pictures of the same size, grey levels.</summary>
    public BlockDifference DifferenceTo(BlockMeans other)
    {
        double greatest = 0;
        double sum = 0;
        for (int i = 0; i < _means.Length; i++)
        {
            double difference = Math.Abs(_means[i] - other._means[i]);
            greatest = Math.Max(greatest, difference);
            sum += difference;
        }

        return new BlockDifference(greatest, sum / _means.Length);
    }

    /// <summary>
    /// The fraction of blocks that changed after a number of pictures of a still world: by more than a factor times the block's own range
    /// in those, |now - last| > factor (max - min) + levels.
    /// </summary>
    public double ChangedFraction(IReadOnlyList<BlockMeans> still, double factor, double levels)
    {
        BlockMeans last = still[still.Count - 1];
        int changed = 0;
        for (int i = 0; i < _means.Length; i++)
        {
            double range = still.Max(picture => picture._means[i]) - still.Min(picture => picture._means[i]);
            changed += Math.Abs(_means[i] - last._means[i]) > (factor * range) + levels ? 1 : 0;
        }

        return (double)changed / _means.Length;
    }

    /// <summary>
    /// The difference that noise makes between two pictures, from three successive ones: by how much the middle one is off the line between
    /// the others. An even change does not count.
    /// </summary>
    public static BlockDifference NoiseOf(BlockMeans first, BlockMeans second, BlockMeans third)
    {
        var line = new double[first._means.Length];
        var twice = new double[first._means.Length];
        for (int i = 0; i < line.Length; i++)
        {
            line[i] = (first._means[i] + third._means[i]) / SecondToFirst;
            twice[i] = 2 * second._means[i] / SecondToFirst;
        }

        return new BlockMeans(line).DifferenceTo(new BlockMeans(twice));
    }

    private static void Add(PixelBuffer picture, int row, int columns, int[] sums)
    {
        int width = picture.Size.Width;
        byte[] bytes = picture.Bytes;
        int next = row * width * Channels;
        for (int column = 0; column < columns; column++)
        {
            int end = ((row * width) + ((column + 1) * width / columns)) * Channels;
            int red = 0,
                green = 0,
                blue = 0;
            for (; next < end; next += Channels)
            {
                red += bytes[next];
                green += bytes[next + 1];
                blue += bytes[next + 2];
            }

            sums[column * Channels] += red;
            sums[(column * Channels) + 1] += green;
            sums[(column * Channels) + 2] += blue;
        }
    }
}
