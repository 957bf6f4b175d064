namespace Harvester.Play.Tapes;

/// <summary>The constants of a tape file; docs/tape.md describes it.</summary>
public static class TapeFormat
{
    /// <summary>The version that is written.</summary>
    public const int Version = 2;

    /// <summary>The first version, which is read too: its chunks are compressed with Deflate only.</summary>
    public const int FirstVersion = 1;

    /// <summary>Extension of the files.</summary>
    public const string Extension = ".tape";

    /// <summary>Largest size of an unpacked chunk, bytes: a picture of 3840 x 2160 pixels and the entries beside it.</summary>
    public const int MaxChunkBytes = 32 << 20;

    /// <summary>Largest size of all unpacked chunks, bytes.</summary>
    public const long MaxUnpackedBytes = 4L << 30;

    /// <summary>Bytes of the lengths and the checksum in front of each chunk.</summary>
    public const int ChunkHeaderBytes = 12;

    /// <summary>The first bytes of a file, before the version.</summary>
    internal static readonly byte[] Magic = [(byte)'G', (byte)'D', (byte)'H', (byte)'T', (byte)'A', (byte)'P', (byte)'E'];
}
