using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Which objects are hidden in which picture of a coded mask. Every object has a code word of a few bits. The pictures are: one with all
/// objects; for each bit one without the objects whose word has it and one without the others; one without any; and again one with all,
/// from which the noise is estimated. Words are unique. Objects that may touch in the image get words that differ in about half of their
/// bits, so that pictures show each of the two alone, both, and neither.
/// </summary>
public sealed class VisibilityCode : IPicturePlan
{
    /// <summary>Words of this many bits separate neighbours well; they give 17 pictures.</summary>
    private const int AmpleBits = 7;

    /// <summary>Bits beyond those that make the words unique, up to <see cref="AmpleBits"/>.</summary>
    private const int SpareBits = 2;

    /// <summary>
    /// The boxes of objects that may touch, or shade each other, are closer than this fraction of their size, and pixels.
    /// </summary>
    private const double NearFraction = 0.25;
    private const double NearPixels = 8;

    private readonly Camera _camera;
    private readonly IReadOnlyList<MapTarget> _targets;
    private readonly uint[] _words;

    private VisibilityCode(Camera camera, IReadOnlyList<MapTarget> targets, int bits)
    {
        _camera = camera;
        _targets = targets;
        _words = Words(targets, bits);
        Bits = bits;
    }

    /// <summary>Number of bits of a word; 1 to 14.</summary>
    public int Bits { get; }

    /// <inheritdoc/>
    public int PictureCount => (2 * Bits) + 3;

    /// <summary>The picture without any object.</summary>
    public int NonePicture => (2 * Bits) + 1;

    /// <summary>Assigns words to targets.</summary>
    /// <param name="camera">The camera of the pictures.</param>
    /// <param name="targets">The targets, at most 16,384.</param>
    /// <exception cref="ArgumentOutOfRangeException">There are more targets.</exception>
    public static VisibilityCode For(Camera camera, IReadOnlyList<MapTarget> targets)
    {
        Guard.NotNull(camera, nameof(camera));
        const int maxBits = 14;
        if (Guard.NotNull(targets, nameof(targets)).Count > 1 << maxBits)
        {
            throw new ArgumentOutOfRangeException(nameof(targets), targets.Count, "There are too many targets to hide.");
        }

        // The fewest bits b with 2^b ≥ targets + 1.
        int least = 1;
        while (1 << least < targets.Count + 1 && least < maxBits)
        {
            least++;
        }

        int bits = Math.Max(least, Math.Min(AmpleBits, least + SpareBits));
        return new VisibilityCode(camera, targets, bits);
    }

    /// <summary>The code word of a target.</summary>
    /// <param name="target">Its index, from 0.</param>
    public uint WordOf(int target) => _words[target];

    /// <inheritdoc/>
    public bool IsShown(int picture, int target)
    {
        if (picture == 0 || picture == NonePicture + 1)
        {
            return true;
        }

        bool hasBit = ((_words[target] >> ((picture - 1) / 2)) & 1) == 1;
        return picture != NonePicture && hasBit == (picture % 2 == 0);
    }

    /// <inheritdoc/>
    public IReadOnlyList<ScreenSheet> Sheets(int picture) => [];

    /// <inheritdoc/>
    public IMaskDecoder Decoder(IReadOnlyList<byte[]> pictures) => new CodedMaskDecoder(_camera, _targets, this, pictures);

    /// <summary>The pictures that show a target, as bits: bit 0 is picture 0.</summary>
    internal uint PicturesOf(int target)
    {
        uint pictures = 0;
        for (int picture = 0; picture < PictureCount; picture++)
        {
            pictures |= IsShown(picture, target) ? 1u << picture : 0;
        }

        return pictures;
    }

    private static uint[] Words(IReadOnlyList<MapTarget> targets, int bits)
    {
        var words = new uint[targets.Count];
        var taken = new bool[1 << bits];
        var boxes = new Box2D[targets.Count];
        for (int i = 0; i < boxes.Length; i++)
        {
            boxes[i] = Surroundings(targets[i].Projection.Box ?? default);
        }

        for (int i = 0; i < words.Length; i++)
        {
            // Greedy: each target in turn gets the free word that is farthest from those of its neighbours so far, first by the nearest of
            // them, then by the sum of all distances. The lowest word wins a tie, so that the same targets always get the same words.
            int best = -1;
            (int Least, int Sum) bestApart = (-1, -1);
            for (int word = 0; word < taken.Length; word++)
            {
                if (!taken[word] && ApartOf((uint)word, i) is var apart && apart.CompareTo(bestApart) > 0)
                {
                    (best, bestApart) = (word, apart);
                }
            }

            taken[best] = true;
            words[i] = (uint)best;
        }

        return words;

        // A word and its complement are never hidden together, which separates them as badly as equal words.
        (int Least, int Sum) ApartOf(uint word, int target)
        {
            (int least, int sum) = (bits, 0);
            for (int other = 0; other < target; other++)
            {
                if (boxes[target].Intersect(boxes[other]) is not null)
                {
                    // Hamming distance d; of d and bits - d the smaller counts, which is largest for words that differ in half of their
                    // bits.
                    int different = CountOf(word ^ words[other]);
                    int apart = Math.Min(different, bits - different);
                    least = Math.Min(least, apart);
                    sum += apart;
                }
            }

            return (least, sum);
        }
    }

    private static Box2D Surroundings(Box2D box)
    {
        double across = NearPixels + (NearFraction * box.Width);
        double down = NearPixels + (NearFraction * box.Height);
        return new Box2D(box.XMin - across, box.YMin - down, box.XMax + across, box.YMax + down);
    }

    private static int CountOf(uint bits)
    {
        int count = 0;
        for (; bits != 0; bits &= bits - 1)
        {
            count++;
        }

        return count;
    }
}
