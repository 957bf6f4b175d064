using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging;

/// <summary>
/// Scales images of one size to another: each output pixel is the mean of the area that it covers if the image shrinks, and a linear
/// interpolation of its neighbours if it grows, each axis separately. Pixel coordinates scale exactly: u' = u · width' / width, v' = v ·
/// height' / height. All arithmetic is in integers, so every runtime gives the same bytes. Means are taken of the stored (gamma encoded)
/// values, as image viewers and training pipelines do: a fine pattern of black and white becomes 127, somewhat darker than the light it
/// stands for. Buffers are reused; one scaler serves one thread.
/// </summary>
public sealed class ImageScaler
{
    // Rows are kept with 6 fractional bits between the passes, so that the second pass's sums stay below 2³¹.
    private const int FractionBits = 6;
    private const int RowShift = ScaleAxis.Bits - FractionBits;
    private const int PixelShift = ScaleAxis.Bits + FractionBits;
    private readonly ScaleAxis _columns;
    private readonly ScaleAxis _rows;
    private readonly int[] _row;

    /// <summary>Creates a scaler from one size to another.</summary>
    /// <param name="source">Size of the input images.</param>
    /// <param name="target">Size of the output images.</param>
    public ImageScaler(ImageSize source, ImageSize target)
    {
        Source = source;
        Target = target;
        _columns = new ScaleAxis(source.Width, target.Width);
        _rows = new ScaleAxis(source.Height, target.Height);
        _row = new int[source.Width * PixelBuffer.BytesPerPixel];
    }

    /// <summary>Size of the input images.</summary>
    public ImageSize Source { get; }

    /// <summary>Size of the output images.</summary>
    public ImageSize Target { get; }

    /// <summary>Scales an image. If the sizes are equal, it is copied unchanged.</summary>
    /// <param name="source">An image of the size <see cref="Source"/>.</param>
    /// <param name="target">Receives the result, of the size <see cref="Target"/>; not the same buffer.</param>
    /// <exception cref="ArgumentException">A buffer has another size.</exception>
    public void Scale(PixelBuffer source, PixelBuffer target)
    {
        Check(source, Source, nameof(source));
        Check(target, Target, nameof(target));
        if (Source == Target)
        {
            Buffer.BlockCopy(source.Bytes, 0, target.Bytes, 0, target.Bytes.Length);
            return;
        }

        for (int y = 0; y < Target.Height; y++)
        {
            MixRows(source.Bytes, y);
            MixColumns(target.Bytes, y * Target.Width * PixelBuffer.BytesPerPixel);
        }
    }

    private static void Check(PixelBuffer buffer, ImageSize expected, string name)
    {
        if (buffer is null)
        {
            throw new ArgumentNullException(name);
        }

        if (buffer.Size != expected)
        {
            throw new ArgumentException(
                $"The image is {buffer.Size.Width}x{buffer.Size.Height}; this scaler takes {expected.Width}x{expected.Height}.",
                name
            );
        }
    }

    private void MixRows(byte[] source, int y)
    {
        int[] row = _row;
        Array.Clear(row, 0, row.Length);
        for (int tap = 0; tap < _rows.Count(y); tap++)
        {
            int weight = _rows.Weight(y, tap);
            int from = (_rows.Start(y) + tap) * row.Length;
            for (int i = 0; i < row.Length; i++)
            {
                row[i] += weight * source[from + i];
            }
        }

        for (int i = 0; i < row.Length; i++)
        {
            // Rounded from 14 fractional bits to 6: 255 · 2^6 · 2^14 < 2^28 in the second pass.
            row[i] = (row[i] + (1 << (RowShift - 1))) >> RowShift;
        }
    }

    private void MixColumns(byte[] target, int to)
    {
        const int half = 1 << (PixelShift - 1);
        int[] row = _row;
        for (int x = 0; x < Target.Width; x++)
        {
            int red = half;
            int green = half;
            int blue = half;
            int from = _columns.Start(x) * PixelBuffer.BytesPerPixel;
            for (int tap = 0; tap < _columns.Count(x); tap++)
            {
                int weight = _columns.Weight(x, tap);
                red += weight * row[from++];
                green += weight * row[from++];
                blue += weight * row[from++];
            }

            target[to++] = (byte)(red >> PixelShift);
            target[to++] = (byte)(green >> PixelShift);
            target[to++] = (byte)(blue >> PixelShift);
        }
    }
}
