namespace Harvester.Play.Tapes;

/// <summary>
/// Replaces what a chunk repeats of the bytes before it by references (LZ77, Ziv and Lempel 1977, over a longer distance than Deflate's): a
/// frozen game answers the same in each tick. docs/tape.md describes the result.
/// </summary>
internal sealed class RepeatPacker
{
    private const int SlotBits = 19;

    /// <summary>One place in this many, by its hash, is remembered and looked up: then those within reach have slots enough.</summary>
    private const ulong Sampling = 16;

    // Odd numbers with well-mixed bits, from the fractional parts of the golden ratio and of pi: multiplicative hashing, Knuth 1973.
    private const ulong FirstFactor = 0x9E3779B97F4A7C15;
    private const ulong SecondFactor = 0x243F6A8885A308D3;

    private readonly RepeatWindow _window = new();

    /// <summary>By the hash of 16 bytes: the position after their last occurrence's first byte; 0 for none.</summary>
    private readonly long[] _last = new long[1 << SlotBits];

    /// <summary>Writes a chunk: by turns bytes as they are and a repeated part, until the chunk is complete.</summary>
    public void Pack(byte[] chunk, Stream target)
    {
        _window.MakeRoom(chunk.Length);
        Buffer.BlockCopy(chunk, 0, _window.Bytes, _window.End, chunk.Length);
        (int at, int pending) = (_window.End, _window.End);
        _window.End += chunk.Length;
        while (at <= _window.End - RepeatWindow.MinLength)
        {
            int earlier = Remember(at);
            int distance = at - earlier;
            bool isWithinReach = earlier >= 0 && distance <= RepeatWindow.Reach;
            int before = isWithinReach ? CommonBefore(earlier, at, pending) : 0;
            int length = isWithinReach ? before + CommonFrom(earlier, at) : 0;
            if (length < RepeatWindow.MinLength)
            {
                at++;
                continue;
            }

            Literals(target, pending, at - before);
            Number(target, length - RepeatWindow.MinLength);
            Number(target, distance);
            pending = at - before + length;
            for (at++; at < pending; at++)
            {
                if (at <= _window.End - RepeatWindow.MinLength)
                {
                    Remember(at);
                }
            }
        }

        if (pending < _window.End)
        {
            Literals(target, pending, _window.End);
        }
    }

    /// <summary>Remembers a place if it is sampled; returns the last one with the same hash, or a negative number.</summary>
    private int Remember(int at)
    {
        ulong hash = unchecked(
            (BitConverter.ToUInt64(_window.Bytes, at) * FirstFactor)
            ^ (BitConverter.ToUInt64(_window.Bytes, at + sizeof(ulong)) * SecondFactor)
        );
        hash = unchecked(hash * FirstFactor);
        if ((hash >> 32) % Sampling != 0)
        {
            return -1;
        }

        ref long last = ref _last[hash >> (64 - SlotBits)];
        long earlier = last - 1 - _window.Start;
        last = _window.Start + at + 1;
        return (int)Math.Max(earlier, -1);
    }

    /// <summary>Number of equal bytes before two places, of those that are not written yet.</summary>
    private int CommonBefore(int earlier, int at, int pending)
    {
        byte[] bytes = _window.Bytes;
        int length = 0;
        while (at - length > pending && earlier > length && bytes[earlier - length - 1] == bytes[at - length - 1])
        {
            length++;
        }

        return length;
    }

    /// <summary>Number of equal bytes from two places on.</summary>
    private int CommonFrom(int earlier, int at)
    {
        byte[] bytes = _window.Bytes;
        int length = 0;
        while (at + length < _window.End && bytes[earlier + length] == bytes[at + length])
        {
            length++;
        }

        return length;
    }

    private void Literals(Stream target, int from, int to)
    {
        Number(target, to - from);
        target.Write(_window.Bytes, from, to - from);
    }

    private static void Number(Stream target, int value)
    {
        for (; value > 0x7F; value >>= 7)
        {
            target.WriteByte((byte)(value | 0x80));
        }

        target.WriteByte((byte)value);
    }
}
