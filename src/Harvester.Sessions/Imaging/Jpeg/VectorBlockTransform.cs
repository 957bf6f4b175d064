#if NET
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>The transform in vectors of eight integers: a row of a block at a time. Needs AVX2.</summary>
internal sealed class VectorBlockTransform : BlockTransform
{
    /// <summary>A row is 24 bytes: its upper 16 begin at this index.</summary>
    private const int UpperStart = 8;
    private const byte Zero = 0x80;

    // The lower half of a row's vector holds its bytes 0 to 15, the upper half its bytes 8 to 23.
    private static readonly Vector256<byte> Reds = Spread(0, 4);
    private static readonly Vector256<byte> Greens = Spread(1, 5);
    private static readonly Vector256<byte> Blues = Spread(2, 6);

    private readonly VectorTable _luma;
    private readonly VectorTable _chroma;
    private readonly Vector256<int>[] _y = new Vector256<int>[JpegBlock.Side];
    private readonly Vector256<int>[] _cb = new Vector256<int>[JpegBlock.Side];
    private readonly Vector256<int>[] _cr = new Vector256<int>[JpegBlock.Side];

    public VectorBlockTransform(QuantisationTable luma, QuantisationTable chroma)
    {
        _luma = new VectorTable(luma);
        _chroma = new VectorTable(chroma);
    }

    protected override void Transform(byte[] pixels, int start, int stride, QuantisedBlocks blocks)
    {
        ReadColours(pixels, start, stride);
        Quantise(_y, _luma, blocks, 0);
        Quantise(_cb, _chroma, blocks, 1);
        Quantise(_cr, _chroma, blocks, 2);
    }

    private static void Quantise(Vector256<int>[] rows, VectorTable table, QuantisedBlocks blocks, int component)
    {
        Transpose(rows);
        ForwardDct<Vector256<int>, VectorLanes>.FirstPass(rows, 0, 1);
        Transpose(rows);
        ForwardDct<Vector256<int>, VectorLanes>.SecondPass(rows, 0, 1);
        ulong present = 0;
        for (int row = 0; row < rows.Length; row++)
        {
            Vector256<int> quotients = table.Divided(rows[row], row);
            quotients.CopyTo(blocks.Coefficients, (component * JpegBlock.Length) + (row * JpegBlock.Side));
            present |=
                (ulong)(byte)~Vector256.Equals(quotients, Vector256<int>.Zero).ExtractMostSignificantBits() << (row * JpegBlock.Side);
        }

        blocks.Present[component] = present;
    }

    private void ReadColours(byte[] pixels, int start, int stride)
    {
        for (int row = 0; row < JpegBlock.Side; row++, start += stride)
        {
            Vector256<byte> bytes = Vector256.Create(Vector128.Create(pixels, start), Vector128.Create(pixels, start + UpperStart));
            Vector256<int> red = Avx2.Shuffle(bytes, Reds).AsInt32();
            Vector256<int> green = Avx2.Shuffle(bytes, Greens).AsInt32();
            Vector256<int> blue = Avx2.Shuffle(bytes, Blues).AsInt32();
            _y[row] =
                (
                    (
                        (red * ColourWeights.RedInY)
                        + (green * ColourWeights.GreenInY)
                        + (blue * ColourWeights.BlueInY)
                        + Vector256.Create(ColourWeights.RoundingOfY)
                    ) >> ColourWeights.Bits
                ) - Vector256.Create(ColourWeights.LevelShift);
            _cb[row] =
                (
                    (red * ColourWeights.RedInCb)
                    + (green * ColourWeights.GreenInCb)
                    + (blue * ColourWeights.Half)
                    + Vector256.Create(ColourWeights.RoundingOfColour)
                ) >> ColourWeights.Bits;
            _cr[row] =
                (
                    (red * ColourWeights.Half)
                    + (green * ColourWeights.GreenInCr)
                    + (blue * ColourWeights.BlueInCr)
                    + Vector256.Create(ColourWeights.RoundingOfColour)
                ) >> ColourWeights.Bits;
        }
    }

    /// <summary>Every third byte from a position of each half, each as an integer of 32 bits.</summary>
    private static Vector256<byte> Spread(byte lower, byte upper) => Vector256.Create(Spread(lower), Spread(upper));

    private static Vector128<byte> Spread(byte from) =>
        Vector128.Create(
            from,
            Zero,
            Zero,
            Zero,
            (byte)(from + 3),
            Zero,
            Zero,
            Zero,
            (byte)(from + 6),
            Zero,
            Zero,
            Zero,
            (byte)(from + 9),
            Zero,
            Zero,
            Zero
        );

    private static void Transpose(Vector256<int>[] rows)
    {
        if (rows.Length != JpegBlock.Side)
        {
            throw new ArgumentException("A block has eight rows.", nameof(rows));
        }

        // Interleave pairs of rows, then pairs of pairs, then exchange the halves.
        (Vector256<long> a, Vector256<long> b) = Interleaved(rows[0], rows[1]);
        (Vector256<long> c, Vector256<long> d) = Interleaved(rows[2], rows[3]);
        (Vector256<long> e, Vector256<long> f) = Interleaved(rows[4], rows[5]);
        (Vector256<long> g, Vector256<long> h) = Interleaved(rows[6], rows[7]);
        (rows[0], rows[4]) = Halves(Avx2.UnpackLow(a, c), Avx2.UnpackLow(e, g));
        (rows[1], rows[5]) = Halves(Avx2.UnpackHigh(a, c), Avx2.UnpackHigh(e, g));
        (rows[2], rows[6]) = Halves(Avx2.UnpackLow(b, d), Avx2.UnpackLow(f, h));
        (rows[3], rows[7]) = Halves(Avx2.UnpackHigh(b, d), Avx2.UnpackHigh(f, h));
    }

    private static (Vector256<long> Low, Vector256<long> High) Interleaved(Vector256<int> left, Vector256<int> right) =>
        (Avx2.UnpackLow(left, right).AsInt64(), Avx2.UnpackHigh(left, right).AsInt64());

    private static (Vector256<int> Lower, Vector256<int> Upper) Halves(Vector256<long> left, Vector256<long> right) =>
        (Avx2.Permute2x128(left, right, 0x20).AsInt32(), Avx2.Permute2x128(left, right, 0x31).AsInt32());

    /// <summary>A quantisation table by rows.</summary>
    private sealed class VectorTable(QuantisationTable table)
    {
        private readonly Vector256<int>[] _halves = Rows(table.Halves);
        private readonly Vector256<int>[] _multipliers = Rows(table.Multipliers);
        private readonly Vector256<uint>[] _shifts = [.. Array.ConvertAll(Rows(table.Shifts), static row => row.AsUInt32())];

        public Vector256<int> Divided(Vector256<int> values, int row)
        {
            Vector256<int> products = (Vector256.Abs(values) + _halves[row]) * _multipliers[row];
            return Avx2.Sign(Avx2.ShiftRightLogicalVariable(products, _shifts[row]), values);
        }

        private static Vector256<int>[] Rows(int[] values)
        {
            var rows = new Vector256<int>[JpegBlock.Side];
            for (int row = 0; row < rows.Length; row++)
            {
                rows[row] = Vector256.Create(values, row * JpegBlock.Side);
            }

            return rows;
        }
    }
}
#endif
