using System.Runtime.CompilerServices;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// Bits of a scan, the highest first. It is copied into a local variable while a block is written, so that its fields stay in registers;
/// only one of two copies may be used afterwards.
/// </summary>
internal struct BitSink
{
    private const int BitsOfByte = 8;
    private const int BytesAtOnce = sizeof(ulong);
    private byte[] _bytes;
    private int _count;

    /// <summary>Bits that do not fill a byte yet, from the highest.</summary>
    private ulong _pending;
    private int _room;

    /// <summary>Creates an empty sink.</summary>
    /// <param name="bytes">The initial buffer.</param>
    public BitSink(byte[] bytes)
    {
        _bytes = bytes;
        _count = 0;
        _pending = 0;
        _room = 64;
    }

    /// <summary>The current buffer.</summary>
    public readonly byte[] Storage => _bytes;

    /// <summary>Ensures room for a number of bytes.</summary>
    public void Reserve(int count)
    {
        if (_bytes.Length - _count < count + BytesAtOnce)
        {
            Array.Resize(ref _bytes, Math.Max(2 * _bytes.Length, _count + count + BytesAtOnce));
        }
    }

    /// <summary>Appends the lowest bits, at most 32; the higher ones must be 0. There must be room.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Append(uint bits, int count)
    {
        // All pending bits are written each time and only whole bytes are counted: an unpredictable branch would cost more.
        _room -= count;
        _pending |= (ulong)bits << _room;
        Store(_bytes, _count, _pending);
        int whole = (int)((uint)(64 - _room) / BitsOfByte);
        _count += whole;
        _pending <<= whole * BitsOfByte;
        _room += whole * BitsOfByte;
    }

    /// <summary>
    /// Fills the last byte with ones and writes all bytes; a byte of ones is followed by one of zeros, since it would otherwise begin a
    /// marker.
    /// </summary>
    public void Finish(Stream target)
    {
        Append((1 << (BitsOfByte - 1)) - 1, BitsOfByte - 1);
        int start = 0;
        for (int ones; (ones = Array.IndexOf(_bytes, byte.MaxValue, start, _count - start)) >= 0; start = ones + 1)
        {
            target.Write(_bytes, start, ones + 1 - start);
            target.WriteByte(0);
        }

        target.Write(_bytes, start, _count - start);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(byte[] bytes, int at, ulong value)
    {
#if NET
        System.Buffers.Binary.BinaryPrimitives.WriteUInt64BigEndian(bytes.AsSpan(at), value);
#else
        for (int i = 0; i < 5; i++)
        {
            bytes[at + i] = (byte)(value >> (64 - BitsOfByte - (BitsOfByte * i)));
        }
#endif
    }
}
