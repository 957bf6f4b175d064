using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>The parts of a file before and after the coded pixels: T.81, annex B, and the JFIF marker.</summary>
internal sealed class JpegHeader
{
    private const byte StartOfImage = 0xD8;
    private const byte EndOfImage = 0xD9;
    private const byte ApplicationData = 0xE0;
    private const byte DefineQuantisation = 0xDB;
    private const byte BaselineFrame = 0xC0;
    private const byte DefineHuffman = 0xC4;
    private const byte StartOfScan = 0xDA;
    private const byte BitsOfSample = 8;
    private const byte NoSubsampling = 0x11;
    private const int HeightAt = 1;
    private const int WidthAt = 3;

    /// <summary>JFIF 1.01, pixels are square, no thumbnail.</summary>
    private static readonly byte[] Jfif = [(byte)'J', (byte)'F', (byte)'I', (byte)'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0];

    /// <summary>
    /// Three components; the first with the luma tables, the others with the chroma tables; all coefficients at full precision.
    /// </summary>
    private static readonly byte[] Scan = [JpegBlock.Components, 1, 0x00, 2, 0x11, 3, 0x11, 0, 63, 0];

    private readonly QuantisationTable _luma;
    private readonly QuantisationTable _chroma;

    public JpegHeader(QuantisationTable luma, QuantisationTable chroma)
    {
        _luma = luma;
        _chroma = chroma;
    }

    public void Write(ImageSize size, Stream target)
    {
        WriteMarker(target, StartOfImage);
        WriteSegment(target, ApplicationData, Jfif);
        WriteSegment(target, DefineQuantisation, [0, .. InFileOrder(_luma)]);
        WriteSegment(target, DefineQuantisation, [1, .. InFileOrder(_chroma)]);
        WriteSegment(target, BaselineFrame, Frame(size));
        WriteSegment(target, DefineHuffman, [0x00, .. HuffmanTable.LumaDc.Definition]);
        WriteSegment(target, DefineHuffman, [0x10, .. HuffmanTable.LumaAc.Definition]);
        WriteSegment(target, DefineHuffman, [0x01, .. HuffmanTable.ChromaDc.Definition]);
        WriteSegment(target, DefineHuffman, [0x11, .. HuffmanTable.ChromaAc.Definition]);
        WriteSegment(target, StartOfScan, Scan);
    }

    public static void WriteEnd(Stream target) => WriteMarker(target, EndOfImage);

    private static byte[] InFileOrder(QuantisationTable table) => [.. JpegBlock.ZigZag.Select(place => table.Divisors[place])];

    private static byte[] Frame(ImageSize size)
    {
        byte[] frame = [BitsOfSample, 0, 0, 0, 0, JpegBlock.Components, 1, NoSubsampling, 0, 2, NoSubsampling, 1, 3, NoSubsampling, 1];
        frame[HeightAt] = (byte)(size.Height >> 8);
        frame[HeightAt + 1] = (byte)size.Height;
        frame[WidthAt] = (byte)(size.Width >> 8);
        frame[WidthAt + 1] = (byte)size.Width;
        return frame;
    }

    private static void WriteMarker(Stream target, byte marker)
    {
        target.WriteByte(0xFF);
        target.WriteByte(marker);
    }

    private static void WriteSegment(Stream target, byte marker, byte[] content)
    {
        int length = content.Length + 2;
        WriteMarker(target, marker);
        target.WriteByte((byte)(length >> 8));
        target.WriteByte((byte)length);
        target.Write(content, 0, content.Length);
    }
}
