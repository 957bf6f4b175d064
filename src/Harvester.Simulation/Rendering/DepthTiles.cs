using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// The farthest thing drawn so far in each square tile of the image: what is farther than that in all its tiles cannot be seen.
/// </summary>
internal sealed class DepthTiles
{
    /// <summary>Side of a tile, pixels.</summary>
    public const int Size = 16;

    /// <summary>Room for the rounding of single precision.</summary>
    private const double Room = 1 + 1e-6;

    private readonly int _across;
    private readonly int _width;
    private readonly float[] _least;

    public DepthTiles(int width, int height)
    {
        _width = width;
        _across = (width + Size - 1) / Size;
        _least = new float[_across * ((height + Size - 1) / Size)];
    }

    public void Clear() => Array.Clear(_least);

    /// <summary>Takes what has been drawn in a row of tiles.</summary>
    /// <param name="row">The row of tiles.</param>
    /// <param name="nearness">Near / depth of all pixels of the image; 0 where nothing is drawn.</param>
    public void Update(int row, ReadOnlySpan<float> nearness)
    {
        int top = row * Size;
        int bottom = Math.Min(top + Size, nearness.Length / _width);
        for (int tile = 0; tile < _across; tile++)
        {
            int left = tile * Size;
            _least[(row * _across) + tile] = Least(nearness, top, bottom, left, Math.Min(Size, _width - left));
        }
    }

    /// <summary>Whether something nowhere nearer than given is hidden at all pixels of a rectangle.</summary>
    public bool Hide(PixelRectangle pixels, double nearness)
    {
        double wanted = nearness * Room;
        int right = (pixels.Right - 1) / Size;
        int bottom = (pixels.Bottom - 1) / Size;
        for (int row = pixels.Top / Size; row <= bottom; row++)
        {
            for (int column = pixels.Left / Size; column <= right; column++)
            {
                if (_least[(row * _across) + column] < wanted)
                {
                    return false;
                }
            }
        }

        return true;
    }

    private float Least(ReadOnlySpan<float> nearness, int top, int bottom, int left, int width)
    {
        if (width < Size)
        {
            float least = float.PositiveInfinity;
            for (int row = top; row < bottom; row++)
            {
                foreach (float value in nearness.Slice((row * _width) + left, width))
                {
                    least = Math.Min(least, value);
                }
            }

            return least;
        }

        Vector256<float> both = Vector256.Create(float.PositiveInfinity);
        for (int row = top; row < bottom; row++)
        {
            ReadOnlySpan<float> values = nearness.Slice((row * _width) + left, Size);
            Vector256<float> half = Vector256.Create(values);
            both = Vector256.MinNative(both, Vector256.MinNative(half, Vector256.Create(values[Vector256<float>.Count..])));
        }

        Vector128<float> four = Vector128.MinNative(both.GetLower(), both.GetUpper());
        return Math.Min(Math.Min(four[0], four[1]), Math.Min(four[2], four[3]));
    }
}
