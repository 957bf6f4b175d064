using System.Buffers.Binary;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>A marker segment of a JPEG file: ITU-T T.81, annex B.</summary>
/// <param name="Marker">The marker's second byte.</param>
/// <param name="Content">The bytes after the length.</param>
internal sealed record JpegSegment(byte Marker, byte[] Content)
{
    public const byte BaselineFrame = 0xC0;
    public const byte ExtendedFrame = 0xC1;
    public const byte ProgressiveFrame = 0xC2;
    public const byte DefineHuffman = 0xC4;
    public const byte FirstRestart = 0xD0;
    public const byte LastRestart = 0xD7;
    public const byte StartOfImage = 0xD8;
    public const byte EndOfImage = 0xD9;
    public const byte StartOfScan = 0xDA;
    public const byte DefineQuantisation = 0xDB;
    public const byte DefineRestart = 0xDD;
    public const byte AdobeData = 0xEE;

    private const byte FillByte = 0xFF;
    private const byte LastFrame = 0xCF;
    private const byte ReservedForExtensions = 0xC8;
    private const byte DefineArithmetic = 0xCC;
    private const int MinFrameLength = 6;

    /// <summary>Whether the segment is a frame header: size and components.</summary>
    public bool IsFrame => Marker is >= BaselineFrame and <= LastFrame and not (DefineHuffman or ReservedForExtensions or DefineArithmetic);

    /// <summary>Width and height in a frame header, pixels.</summary>
    public ImageSize Size =>
        DeclaredSize.Of(BinaryPrimitives.ReadUInt16BigEndian(Content.AsSpan(3)), BinaryPrimitives.ReadUInt16BigEndian(Content.AsSpan(1)));

    /// <summary>Bits per sample in a frame header.</summary>
    public int BitsPerSample => Content[0];

    /// <summary>Number of components in a frame header.</summary>
    public int Components => Content[5];

    /// <summary>The segments from the start of a file to the scan header, which is the last.</summary>
    /// <exception cref="DatasetFormatException">The segments are damaged or truncated; the message refers to the file as "it".</exception>
    public static IEnumerable<JpegSegment> ReadHeader(Stream file)
    {
        if (file.ReadByte() != FillByte || file.ReadByte() != StartOfImage)
        {
            throw Damaged();
        }

        JpegSegment segment;
        do
        {
            segment = Read(file);
            yield return segment;
        } while (segment.Marker != StartOfScan);
    }

    private static JpegSegment Read(Stream file)
    {
        int marker = file.ReadByte() == FillByte ? FillByte : throw Damaged();
        while (marker == FillByte)
        {
            marker = file.ReadByte();
        }

        int length = (file.ReadByte() << 8) | file.ReadByte();
        if (length < 2)
        {
            throw Damaged();
        }

        byte[] content = new byte[length - 2];
        if (file.ReadAtLeast(content, content.Length, throwOnEndOfStream: false) < content.Length)
        {
            throw Damaged();
        }

        var segment = new JpegSegment((byte)marker, content);
        return segment.IsFrame && content.Length < MinFrameLength ? throw Damaged() : segment;
    }

    private static DatasetFormatException Damaged() => new("its JPEG header is damaged or cut off.");
}
