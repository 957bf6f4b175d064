namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>The values of one pixel in all pictures, and their statistics over groups of pictures. A group is a set of bits.</summary>
internal sealed class PictureStack
{
    private readonly IReadOnlyList<byte[]> _pictures;
    private readonly float[] _values;

    public PictureStack(IReadOnlyList<byte[]> pictures)
    {
        _pictures = pictures;
        _values = new float[3 * pictures.Count];
    }

    public int Count => _pictures.Count;

    /// <summary>The group of all pictures.</summary>
    public uint All => (uint)((1UL << Count) - 1);

    public static int CountOf(uint group)
    {
        int count = 0;
        for (; group != 0; group &= group - 1)
        {
            count++;
        }

        return count;
    }

    public byte[] Picture(int number) => _pictures[number];

    /// <summary>Reads a pixel's values from all pictures; the statistics are about it from then on.</summary>
    public void Load(int pixel)
    {
        for (int picture = 0; picture < _pictures.Count; picture++)
        {
            byte[] bytes = _pictures[picture];
            _values[3 * picture] = bytes[3 * pixel];
            _values[(3 * picture) + 1] = bytes[(3 * pixel) + 1];
            _values[(3 * picture) + 2] = bytes[(3 * pixel) + 2];
        }
    }

    /// <summary>The sum of the squared deviations from the group's mean, over the three channels.</summary>
    public double SquaresIn(uint group)
    {
        (double r, double g, double b, double squares, int count) = (0, 0, 0, 0, 0);
        for (int i = 0; group != 0; group >>= 1, i += 3)
        {
            if ((group & 1) != 0)
            {
                float red = _values[i];
                float green = _values[i + 1];
                float blue = _values[i + 2];
                r += red;
                g += green;
                b += blue;
                squares += (red * red) + (green * green) + (blue * blue);
                count++;
            }
        }

        // Σ|x - mean|² = Σ|x|² - |Σx|² / n. The sums are whole numbers, exact as doubles.
        return count == 0 ? 0 : squares - (((r * r) + (g * g) + (b * b)) / count);
    }

    /// <summary>The group's mean colour; the group must not be empty.</summary>
    public Vector3D MeanIn(uint group)
    {
        (double r, double g, double b, int count) = (0, 0, 0, 0);
        for (int i = 0; group != 0; group >>= 1, i += 3)
        {
            if ((group & 1) != 0)
            {
                r += _values[i];
                g += _values[i + 1];
                b += _values[i + 2];
                count++;
            }
        }

        return new Vector3D(r, g, b) / count;
    }
}
