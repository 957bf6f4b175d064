using System;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Images.Jpeg;

/// <summary>
/// The bits of a scan, the highest of each byte first, without the bytes of zeros that follow bytes of ones: T.81, annex F.2.2.5.
/// </summary>
internal sealed class JpegBits
{
    private const byte Ones = 0xFF;
    private readonly ReadOnlyMemory<byte> _scan;
    private int _at;
    private uint _bits;
    private int _count;

    /// <summary>Bits of 0 that stand in for those beyond the end.</summary>
    private int _invented;

    public JpegBits(ReadOnlyMemory<byte> scan)
    {
        _scan = scan;
    }

    /// <summary>Whether bits beyond the end were read.</summary>
    public bool IsOverrun => _invented > _count;

    /// <summary>The next bits as a number; beyond the end they are 0.</summary>
    /// <param name="count">How many, 16 at most.</param>
    public int Peek(int count)
    {
        Fill(count);
        return (int)((_bits >> (_count - count)) & ((1u << count) - 1));
    }

    /// <summary>Passes over bits that were looked at.</summary>
    public void Skip(int count) => _count -= count;

    /// <summary>A value of so many bits after the sign rule of T.81, figure F.12: those that begin with 0 are negative.</summary>
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

    /// <summary>Goes on after the restart marker that must come next.</summary>
    /// <exception cref="DatasetFormatException">There is none.</exception>
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
