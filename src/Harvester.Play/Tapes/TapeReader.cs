using System.IO.Compression;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Play.Tapes;

/// <summary>
/// Reads a tape chunk by chunk, so that memory stays bounded. A file that ends within a chunk is a recording that was interrupted: what is
/// whole is read.
/// </summary>
/// <param name="file">The file, from its start.</param>
public sealed class TapeReader(Stream file)
{
    private long _unpacked;
    private RepeatUnpacker? _repeats;

    /// <summary>Whether the file ended within a chunk or without the entry that ends a recording; known after the last entry.</summary>
    public bool IsInterrupted { get; private set; }

    /// <summary>The entries; can be read once.</summary>
    /// <exception cref="InvalidDataException">The file is not a tape, has another version, or is damaged; the message begins with "it".
    /// </exception>
    public IEnumerable<TapeEntry> Entries()
    {
        CheckHead();
        var decoder = new TapeDecoder();
        while (NextChunk() is { } chunk)
        {
            foreach (TapeEntry entry in decoder.EntriesOf(chunk))
            {
                yield return entry;
                if (entry is TapeEnd)
                {
                    yield break;
                }
            }
        }

        IsInterrupted = true;
    }

    private void CheckHead()
    {
        byte[] head = new byte[TapeFormat.Magic.Length + 1];
        if (Fill(file, head) < head.Length || !TapeFormat.Magic.SequenceEqual(head.Take(TapeFormat.Magic.Length)))
        {
            throw new InvalidDataException("it is not a tape.");
        }

        const int first = TapeFormat.FirstVersion;
        const int last = TapeFormat.Version;
        int version = head[TapeFormat.Magic.Length];
        if (version is not (first or last))
        {
            throw new InvalidDataException(
                FormattableString.Invariant($"it has version {version} of the format; this program reads versions {first} and {last}.")
            );
        }

        _repeats = version == first ? null : new RepeatUnpacker();
    }

    private byte[]? NextChunk()
    {
        byte[] head = new byte[TapeFormat.ChunkHeaderBytes];
        if (Fill(file, head) < head.Length)
        {
            return null;
        }

        uint packedLength = BitConverter.ToUInt32(head, 0);
        uint length = BitConverter.ToUInt32(head, 4);
        if (packedLength > TapeFormat.MaxChunkBytes || length > TapeFormat.MaxChunkBytes)
        {
            throw new InvalidDataException("it is damaged: a chunk exceeds the size limit.");
        }

        _unpacked += length;
        if (_unpacked > TapeFormat.MaxUnpackedBytes)
        {
            throw new InvalidDataException("it exceeds the unpacked-size limit of 4 GiB.");
        }

        byte[] packed = new byte[packedLength];
        return Fill(file, packed) < packed.Length ? null : Unpacked(packed, (int)length, BitConverter.ToUInt32(head, 8));
    }

    private byte[] Unpacked(byte[] packed, int length, uint checksum)
    {
        byte[]? chunk;
        try
        {
            using var data = new BufferedStream(new DeflateStream(new MemoryStream(packed), CompressionMode.Decompress));
            chunk = _repeats is null ? Filled(data, length) : _repeats.Unpack(data, length);
            chunk = data.ReadByte() < 0 && Crc32.Append(0, chunk, length) == checksum ? chunk : null;
        }
        catch (InvalidDataException)
        {
            chunk = null;
        }

        return chunk ?? throw new InvalidDataException("it is damaged: a chunk does not match its checksum.");
    }

    private static byte[] Filled(Stream stream, int length)
    {
        byte[] bytes = new byte[length];
        return Fill(stream, bytes) == length ? bytes : throw new InvalidDataException();
    }

    private static int Fill(Stream stream, byte[] bytes)
    {
        int filled = 0;
        for (int read = 1; read > 0 && filled < bytes.Length; filled += read)
        {
            read = stream.Read(bytes, filled, bytes.Length - filled);
        }

        return filled;
    }
}
