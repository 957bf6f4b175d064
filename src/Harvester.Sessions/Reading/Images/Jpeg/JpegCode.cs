using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>A Huffman table of a file: T.81, annexes C and F.2.2.3.</summary>
internal sealed class JpegCode
{
    private const int MaxCodeLength = 16;
    private readonly byte[] _symbols;

    /// <summary>For each length, the largest code, padded with ones to the maximum length; -1 if there is none.</summary>
    private readonly int[] _greatest = new int[MaxCodeLength + 1];

    /// <summary>For each length, the index of its first symbol minus its first code.</summary>
    private readonly int[] _offsets = new int[MaxCodeLength + 1];

    /// <summary>Creates a table.</summary>
    /// <param name="counts">Number of codes with 1 to 16 bits.</param>
    /// <param name="symbols">The symbols by ascending code.</param>
    public JpegCode(ReadOnlySpan<byte> counts, ReadOnlySpan<byte> symbols)
    {
        _symbols = symbols.ToArray();
        int code = 0;
        int place = 0;
        for (int length = 1; length <= MaxCodeLength; length++, code <<= 1)
        {
            int count = counts[length - 1];
            _offsets[length] = place - code;
            place += count;
            code += count;
            _greatest[length] = count == 0 ? -1 : (code << (MaxCodeLength - length)) - 1;
        }
    }

    /// <summary>Reads a symbol.</summary>
    /// <exception cref="DatasetFormatException">The bits are not a code of the table.</exception>
    public int Read(JpegBits bits)
    {
        int ahead = bits.Peek(MaxCodeLength);
        int length = 1;
        while (length <= MaxCodeLength && ahead > _greatest[length])
        {
            length++;
        }

        int place = length <= MaxCodeLength ? (ahead >> (MaxCodeLength - length)) + _offsets[length] : -1;
        if (place < 0 || place >= _symbols.Length)
        {
            throw new DatasetFormatException("its pixels are damaged.");
        }

        bits.Skip(length);
        return _symbols[place];
    }
}
