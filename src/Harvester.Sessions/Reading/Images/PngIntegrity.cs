using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images;

/// <summary>
/// Checks a PNG file (ISO/IEC 15948) to its last byte: the checksum of every chunk, the checksum of the compressed data, and that the data
/// has the number of rows in the header.
/// </summary>
internal static class PngIntegrity
{
    private const int SignatureLength = 8;
    private const int HeaderLength = 33;
    private const int WidthAt = 16;
    private const int BitDepthAt = 24;
    private const int BlockLength = 1 << 16;

    /// <exception cref="DatasetFormatException">The file is damaged; the message refers to it as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static void Check(string path)
    {
        using FileStream file = InputFile.OpenRead(path);
        byte[] block = new byte[BlockLength];
        CheckChunks(file, block);
        long expected = RowsLength(file);
        file.Position = SignatureLength;
        long length = 0;
        try
        {
            using var rows = new ZLibStream(new PngData(file), CompressionMode.Decompress);
            for (int read = rows.Read(block); read > 0 && length <= expected; read = rows.Read(block))
            {
                length += read;
            }
        }
        catch (InvalidDataException e)
        {
            throw new DatasetFormatException("its pixels are damaged.", e);
        }

        if (length != expected)
        {
            throw new DatasetFormatException("its pixels are damaged.");
        }
    }

    private static void CheckChunks(FileStream file, byte[] block)
    {
        file.Position = SignatureLength;
        byte[] word = new byte[4];
        while (file.Position < file.Length)
        {
            long length = Word(file, word);
            if (length + word.Length + word.Length > file.Length - file.Position)
            {
                throw new DatasetFormatException(
                    FormattableString.Invariant($"it is damaged: a chunk of {length} bytes is longer than the file.")
                );
            }

            file.ReadExactly(word);
            string type = Encoding.Latin1.GetString(word);
            uint checksum = Crc32.Append(0, word, word.Length);
            while (length > 0)
            {
                int count = (int)Math.Min(length, block.Length);
                file.ReadExactly(block, 0, count);
                checksum = Crc32.Append(checksum, block, count);
                length -= count;
            }

            if (Word(file, word) != checksum)
            {
                throw new DatasetFormatException($"it is damaged: the checksum of its chunk {Shown(type)} does not match.");
            }
        }
    }

    private static uint Word(FileStream file, byte[] word)
    {
        file.ReadExactly(word);
        return BinaryPrimitives.ReadUInt32BigEndian(word);
    }

    /// <summary>Length of all rows, each with the byte of its filter.</summary>
    private static long RowsLength(FileStream file)
    {
        Span<byte> header = stackalloc byte[HeaderLength];
        file.Position = 0;
        file.ReadExactly(header);
        int channels = header[BitDepthAt + 1] switch
        {
            2 => 3,
            4 => 2,
            6 => 4,
            _ => 1,
        };
        long width = BinaryPrimitives.ReadUInt32BigEndian(header[WidthAt..]);
        long height = BinaryPrimitives.ReadUInt32BigEndian(header[(WidthAt + 4)..]);
        return header[BitDepthAt + 4] == 0
            ? height * (1 + (((width * channels * header[BitDepthAt]) + 7) / 8))
            : throw new DatasetFormatException("it is interlaced.");
    }

    private static string Shown(string type)
    {
        foreach (char c in type)
        {
            if (!char.IsAsciiLetter(c))
            {
                return "of an unknown type";
            }
        }

        return type;
    }
}
