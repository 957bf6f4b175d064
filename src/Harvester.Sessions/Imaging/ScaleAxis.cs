namespace Harvester.Sessions.Imaging;

/// <summary>
/// The source pixels of each output pixel along one axis, and their weights: the area that the output pixel covers when shrinking, linear
/// interpolation between centres when enlarging. Weights are integers that sum to <see cref="One"/> for each output pixel, so that every
/// runtime computes the same bytes.
/// </summary>
internal sealed class ScaleAxis
{
    public const int Bits = 14;
    public const int One = 1 << Bits;
    private readonly int[] _starts;
    private readonly int[] _counts;
    private readonly int[] _weights;
    private readonly int _stride;

    public ScaleAxis(int source, int target)
    {
        // An interval of length source / target touches at most that many pixels rounded up, and one more if it starts within one.
        _stride = (source / target) + 2;
        _starts = new int[target];
        _counts = new int[target];
        _weights = new int[target * _stride];
        for (int i = 0; i < target; i++)
        {
            if (target <= source)
            {
                Cover(i, source, target);
            }
            else
            {
                Interpolate(i, source, target);
            }
        }
    }

    public int Start(int output) => _starts[output];

    public int Count(int output) => _counts[output];

    public int Weight(int output, int tap) => _weights[(output * _stride) + tap];

    /// <summary>
    /// In units of 1 / target of a source pixel, output i covers [i · source, (i + 1) · source) and source j covers [j · target, (j + 1) ·
    /// target).
    /// </summary>
    private void Cover(int i, long source, long target)
    {
        long begin = i * source;
        long first = begin / target;
        long last = (begin + source - 1) / target;
        _starts[i] = (int)first;
        _counts[i] = (int)(last - first + 1);
        long before = 0;
        for (long j = first; j <= last; j++)
        {
            // Rounding the running sum rather than each weight keeps the whole at exactly One.
            long covered = j == last ? source : ((j + 1) * target) - begin;
            long upToHere = ((covered * One) + (source / 2)) / source;
            _weights[(i * _stride) + (int)(j - first)] = (int)(upToHere - before);
            before = upToHere;
        }
    }

    /// <summary>
    /// The centre of output i lies at ((2i + 1) · source - target) / (2 · target) source pixels from the first one's centre.
    /// </summary>
    private void Interpolate(int i, long source, long target)
    {
        // In units of 1 / (2 · target) source pixels, so that everything is a whole number. Before the first and after the last centre the
        // border pixel is repeated.
        long position = (((2L * i) + 1) * source) - target;
        long first = position < 0 ? -1 : position / (2 * target);
        if (first < 0 || first >= source - 1)
        {
            _starts[i] = first < 0 ? 0 : (int)source - 1;
            _counts[i] = 1;
            _weights[i * _stride] = One;
            return;
        }

        long beyond = position - (first * 2 * target);

        // The fraction on the way to the next centre, rounded to Bits bits.
        int second = (int)(((beyond * One) + target) / (2 * target));
        _starts[i] = (int)first;
        _counts[i] = 2;
        _weights[i * _stride] = One - second;
        _weights[(i * _stride) + 1] = second;
    }
}
