using System.Buffers.Binary;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>The quantisation and Huffman tables in a file's header: T.81, annexes B.2.4.1, B.2.4.2 and B.2.4.4.</summary>
internal sealed class JpegTables
{
    private const int Places = 4;
    private const int Coefficients = 64;
    private const int CodeLengths = 16;

    /// <summary>The quantisation tables, in zigzag order; null where undefined.</summary>
    public int[]?[] Quantisation { get; } = new int[]?[Places];

    /// <summary>The Huffman tables of DC coefficients.</summary>
    public JpegCode?[] Dc { get; } = new JpegCode?[Places];

    /// <summary>The Huffman tables of AC coefficients.</summary>
    public JpegCode?[] Ac { get; } = new JpegCode?[Places];

    /// <summary>Number of MCUs between restart markers; 0 for none.</summary>
    public int RestartInterval { get; private set; }

    /// <summary>Adds the definitions of a segment; segments of other kinds define nothing.</summary>
    public void Apply(JpegSegment segment)
    {
        switch (segment.Marker)
        {
            case JpegSegment.DefineQuantisation:
                ReadQuantisation(segment.Content);
                break;
            case JpegSegment.DefineHuffman:
                ReadCodes(segment.Content);
                break;
            case JpegSegment.DefineRestart:
                RestartInterval = BinaryPrimitives.ReadUInt16BigEndian(segment.Content);
                break;
        }
    }

    private void ReadQuantisation(ReadOnlySpan<byte> content)
    {
        while (content.Length > 0)
        {
            int width = content[0] >> 4 == 0 ? sizeof(byte) : sizeof(ushort);
            int[] divisors = new int[Coefficients];
            for (int i = 0; i < divisors.Length; i++)
            {
                ReadOnlySpan<byte> divisor = content.Slice(1 + (i * width), width);
                divisors[i] = width == 1 ? divisor[0] : BinaryPrimitives.ReadUInt16BigEndian(divisor);
            }

            Quantisation[content[0] & 0xF] = divisors;
            content = content[(1 + (divisors.Length * width))..];
        }
    }

    private void ReadCodes(ReadOnlySpan<byte> content)
    {
        while (content.Length > 0)
        {
            ReadOnlySpan<byte> counts = content.Slice(1, CodeLengths);
            int symbols = 0;
            foreach (byte count in counts)
            {
                symbols += count;
            }

            JpegCode?[] codes = content[0] >> 4 == 0 ? Dc : Ac;
            codes[content[0] & 0xF] = new JpegCode(counts, content.Slice(1 + CodeLengths, symbols));
            content = content[(1 + CodeLengths + symbols)..];
        }
    }
}
