namespace Harvester.Play.Tapes;

/// <summary>The last bytes of the chunks so far, and the chunk in hand after them.</summary>
internal sealed class RepeatWindow
{
    /// <summary>
    /// Largest distance of a repeated part, bytes: several ticks of a crowded place. Deflate alone reaches back 32 KiB, a part of a tick.
    /// </summary>
    public const int Reach = 8 << 20;

    /// <summary>Smallest length of a repeated part, bytes.</summary>
    public const int MinLength = 24;

    /// <summary>The bytes; those from <see cref="End"/> on are free.</summary>
    public byte[] Bytes { get; private set; } = [];

    /// <summary>Number of bytes in use.</summary>
    public int End { get; set; }

    /// <summary>Position of the first byte in all chunks together.</summary>
    public long Start { get; private set; }

    /// <summary>Makes room for a chunk after the bytes in use. Of these, those within reach are kept.</summary>
    public void MakeRoom(int length)
    {
        if (length <= Bytes.Length - End)
        {
            return;
        }

        int kept = Math.Min(End, Reach);
        int size = Math.Max(kept + length, Math.Min(2 * Reach, 2 * (End + length)));
        byte[] bytes = size <= Bytes.Length ? Bytes : new byte[size];
        Buffer.BlockCopy(Bytes, End - kept, bytes, 0, kept);
        Start += End - kept;
        (Bytes, End) = (bytes, kept);
    }
}
