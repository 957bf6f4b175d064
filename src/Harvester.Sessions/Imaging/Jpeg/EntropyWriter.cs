namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// Encodes quantised blocks as a scan: differences of DC coefficients, and runs of zeros before AC coefficients, both in Huffman codes.
/// T.81, annex F.1.2.
/// </summary>
internal sealed class EntropyWriter
{
    private const int SixteenZeros = 0xF0;
    private const int EndOfBlock = 0x00;

    /// <summary>
    /// Upper bound of the bytes of a block: 64 codes of 16 bits with 11 bits of value, each byte followed by a stuffed one.
    /// </summary>
    private const int MaxBytesOfBlock = 512;

    private static readonly byte[] BitsOfMagnitude = MakeBitsOfMagnitude();
    private static readonly byte[] Places = MakePlaces();
    private readonly int[] _previousDc = new int[JpegBlock.Components];
    private readonly int[] _ordered = new int[JpegBlock.Length];
    private BitSink _sink = new(new byte[1 << 16]);

    /// <summary>Begins an image: no bits yet, and differences of DC from 0.</summary>
    public void Begin()
    {
        Array.Clear(_previousDc, 0, _previousDc.Length);
        _sink = new BitSink(_sink.Storage);
    }

    /// <summary>Appends the codes of a block in one component.</summary>
    /// <param name="blocks">The block in all components.</param>
    /// <param name="component">0 for Y, 1 for Cb, 2 for Cr.</param>
    public void Write(QuantisedBlocks blocks, int component)
    {
        int dc = blocks.Coefficients[component * JpegBlock.Length];
        ulong present = Order(blocks, component);
        _sink.Reserve(MaxBytesOfBlock);
        WriteDc(component == 0 ? HuffmanTable.LumaDc : HuffmanTable.ChromaDc, dc - _previousDc[component]);
        WriteAc(component == 0 ? HuffmanTable.LumaAc : HuffmanTable.ChromaAc, present);
        _previousDc[component] = dc;
    }

    /// <summary>Ends the image and writes its scan.</summary>
    public void End(Stream target)
    {
        _sink.Reserve(MaxBytesOfBlock);
        _sink.Finish(target);
    }

    private static byte[] MakeBitsOfMagnitude()
    {
        // Values have at most 11 bits; each power of 2 needs one bit more than its half.
        byte[] bits = new byte[1 << 11];
        for (int i = 1; i < bits.Length; i++)
        {
            bits[i] = (byte)(bits[i / 2] + 1);
        }

        return bits;
    }

    /// <summary>The position in the file's order of each coefficient of a block.</summary>
    private static byte[] MakePlaces()
    {
        byte[] places = new byte[JpegBlock.Length];
        for (int place = 0; place < places.Length; place++)
        {
            places[JpegBlock.ZigZag[place]] = (byte)place;
        }

        return places;
    }

    /// <summary>Sorts the nonzero AC coefficients into the file's order.</summary>
    /// <returns>A bit for each of them, the first position in the lowest.</returns>
    private ulong Order(QuantisedBlocks blocks, int component)
    {
        int[] coefficients = blocks.Coefficients;
        int[] ordered = _ordered;
        byte[] places = Places;
        int start = component * JpegBlock.Length;
        ulong result = 0;
        for (ulong present = blocks.Present[component] & ~1UL; present != 0; present &= present - 1)
        {
            int from = LowestBit.Of(present);
            int place = places[from];
            ordered[place] = coefficients[start + from];
            result |= 1UL << place;
        }

        return result;
    }

    private void WriteDc(HuffmanTable table, int difference)
    {
        int bits = BitsOfMagnitude[Magnitude(difference)];
        _sink.Append((table.Codes[bits] << bits) | ValueBits(difference, bits), table.Lengths[bits] + bits);
    }

    private void WriteAc(HuffmanTable table, ulong present)
    {
        BitSink sink = _sink;
        uint[] codes = table.Codes;
        byte[] lengths = table.Lengths;
        int[] ordered = _ordered;
        byte[] bitsOfMagnitude = BitsOfMagnitude;
        int after = 1;
        for (; present != 0; present &= present - 1)
        {
            int place = LowestBit.Of(present);

            // Run-length coding: a symbol has the number of zeros before a value in its upper four bits and the value's bits in the lower
            // four; sixteen zeros have a symbol of their own.
            int run = place - after;
            after = place + 1;
            for (; run > 15; run -= 16)
            {
                sink.Append(codes[SixteenZeros], lengths[SixteenZeros]);
            }

            int value = ordered[place];
            int bits = bitsOfMagnitude[Magnitude(value)];
            int symbol = (run << 4) | bits;
            sink.Append((codes[symbol] << bits) | ValueBits(value, bits), lengths[symbol] + bits);
        }

        if (after < JpegBlock.Length)
        {
            sink.Append(codes[EndOfBlock], lengths[EndOfBlock]);
        }

        _sink = sink;
    }

    /// <summary>Like Math.Abs, without its branch: signs are random, so that it would be mispredicted half the time.</summary>
    private static int Magnitude(int value) => (value ^ (value >> 31)) - (value >> 31);

    /// <summary>A positive value unchanged, a negative one minus 1, in a number of bits: T.81, figure F.4.</summary>
    private static uint ValueBits(int value, int bits) => (uint)((value + (value >> 31)) & ((1 << bits) - 1));
}
