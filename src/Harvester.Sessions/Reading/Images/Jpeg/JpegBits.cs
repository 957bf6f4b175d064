using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>The bits of a scan, most significant first, without the zero byte stuffed after each 0xFF: T.81, annex F.2.2.5.</summary>
internal sealed class JpegBits
{
    private const byte Ones = 0xFF;
    private readonly ReadOnlyMemory<byte> _scan;
    private int _at;
    private uint _bits;
    private int _count;

    /// <summary>Number of zero bits that replace bits beyond the end.</summary>
    private int _invented;

    public JpegBits(ReadOnlyMemory<byte> scan)
    {
        _scan = scan;
    }

    /// <summary>Whether bits beyond the end were read.</summary>
    public bool IsOverrun => _invented > _count;

    /// <summary>The next bits as a number, without consuming them; beyond the end they are 0.</summary>
    /// <param name="count">Number of bits, at most 16.</param>
    public int Peek(int count)
    {
        Fill(count);
        return (int)((_bits >> (_count - count)) & ((1u << count) - 1));
    }

    /// <summary>Consumes bits.</summary>
    public void Skip(int count) => _count -= count;

    /// <summary>Reads a value of a number of bits by the sign rule of T.81, figure F.12: values that begin with 0 are negative.</summary>
    public int ReadValue(int count)
    {
        if (count == 0)
        {
            return 0;
        }

        int value = Peek(count);
        Skip(count);
        return value >> (count - 1) == 0 ? value - (1 << count) + 1 : value;
    }

    /// <summary>Skips the restart marker that must come next.</summary>
    /// <exception cref="DatasetFormatException">There is no restart marker.</exception>
    public void PassRestart()
    {
        ReadOnlySpan<byte> scan = _scan.Span;
        _count = 0;
        _invented = 0;
        if (_at + 1 >= scan.Length || scan[_at] != Ones || scan[_at + 1] is < JpegSegment.FirstRestart or > JpegSegment.LastRestart)
        {
            throw new DatasetFormatException("its pixels are damaged.");
        }

        _at += 2;
    }

    private void Fill(int count)
    {
        const int bitsOfByte = 8;
        ReadOnlySpan<byte> scan = _scan.Span;
        for (; _count < count; _count += bitsOfByte)
        {
            bool isEnd = _at >= scan.Length || (scan[_at] == Ones && (_at + 1 == scan.Length || scan[_at + 1] != 0));
            _bits = (_bits << bitsOfByte) | (isEnd ? (byte)0 : scan[_at]);
            if (isEnd)
            {
                _invented += bitsOfByte;
            }
            else
            {
                _at += scan[_at] == Ones ? 2 : 1;
            }
        }
    }
}
