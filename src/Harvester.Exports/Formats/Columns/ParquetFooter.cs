using System.Buffers.Binary;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// What a Parquet file says of itself, read and checked before a library that believes it does so: schema, row groups, and where the pages
/// of their columns are (https://github.com/apache/parquet-format, parquet.thrift, whose numbers of fields these are).
/// </summary>
internal sealed class ParquetFooter
{
    /// <summary>Footers of tables of 10 million frames have less.</summary>
    private const int MaxBytes = 64 << 20;

    /// <summary>A group of the longest texts has less.</summary>
    private const int MaxPageBytes = 256 << 20;

    private const int MaxPageHeaderBytes = 1 << 14;

    /// <summary>The writer makes a dictionary and a page for a column of a group, 600,000 for ten million frames.</summary>
    private const int MaxPages = 1_000_000;
    private const int Uncompressed = 0;
    private const int Zstd = 6;

    /// <summary>"PAR1", at both ends of a file.</summary>
    private const uint Mark = 0x31524150;

    private ParquetFooter(ThriftStruct file) => File = file;

    /// <summary>The structure FileMetaData.</summary>
    private ThriftStruct File { get; }

    /// <summary>Number of rows.</summary>
    public long Rows => File.Number(3) ?? 0;

    /// <summary>Names of the columns and types of their values, or of their lists' items.</summary>
    public IEnumerable<(string Name, long? Type)> Columns
    {
        get
        {
            ThriftStruct[] elements = [.. File.Structs(2).Skip(1)];
            for (int i = 0; i < elements.Length; i++)
            {
                string name = elements[i].Text(4) ?? "";

                // The items of a list are the element within its repeated group.
                while (i < elements.Length - 1 && elements[i].Number(5) is 1)
                {
                    i++;
                }

                yield return (name, elements[i].Number(1));
            }
        }
    }

    /// <summary>Reads the footer of a file, and checks where it says that its pages are.</summary>
    /// <param name="file">The file, which can seek.</param>
    /// <param name="maxRowsOfGroup">The most rows of a group.</param>
    /// <exception cref="DatasetFormatException">It is damaged, or not one that this program writes.</exception>
    public static ParquetFooter Read(Stream file, int maxRowsOfGroup)
    {
        Span<byte> ends = stackalloc byte[3 * sizeof(uint)];
        if (file.Length < ends.Length)
        {
            throw new DatasetFormatException("it is too short for a Parquet file.");
        }

        file.ReadExactly(ends[..4]);
        file.Seek(-8, SeekOrigin.End);
        file.ReadExactly(ends[4..]);
        uint length = BinaryPrimitives.ReadUInt32LittleEndian(ends[4..]);
        if (BinaryPrimitives.ReadUInt32LittleEndian(ends) != Mark || BinaryPrimitives.ReadUInt32LittleEndian(ends[8..]) != Mark)
        {
            throw new DatasetFormatException("it is no Parquet file, or it is cut off.");
        }

        if (length > MaxBytes || length > file.Length - ends.Length)
        {
            throw new DatasetFormatException($"its footer has {length} bytes, more than the file or {MaxBytes}.");
        }

        byte[] bytes = new byte[length];
        file.Seek(-8 - length, SeekOrigin.End);
        file.ReadExactly(bytes);
        var footer = new ParquetFooter(new ThriftReader(bytes).Struct());
        footer.CheckGroups(file, file.Length - 8 - length, maxRowsOfGroup);
        return footer;
    }

    private void CheckGroups(Stream file, long end, int maxRowsOfGroup)
    {
        long rows = 0;
        long begin = sizeof(uint);
        int pages = 0;
        int columns = Columns.Count();
        foreach (ThriftStruct group in File.Structs(4))
        {
            long here = group.Number(3) ?? 0;
            if (here < 0 || here > maxRowsOfGroup)
            {
                throw new DatasetFormatException($"a row group has {here} rows; the format has at most {maxRowsOfGroup}.");
            }

            rows += here;
            ThriftStruct[] chunks = [.. group.Structs(1)];
            if (chunks.Length != columns)
            {
                throw new DatasetFormatException($"a row group has {chunks.Length} columns instead of {columns}.");
            }

            foreach (ThriftStruct chunk in chunks)
            {
                ThriftStruct description = chunk.Struct(3) ?? throw new DatasetFormatException("a column has no description.");
                begin = CheckPages(file, description, begin, end, ref pages);
            }
        }

        if (rows != Rows)
        {
            throw new DatasetFormatException($"it has {rows} rows, but says {Rows}.");
        }
    }

    /// <summary>Walks through the pages of a column: each must be within the column, and the columns follow each other.</summary>
    /// <returns>Where the column ends.</returns>
    private static long CheckPages(Stream file, ThriftStruct chunk, long begin, long end, ref int pages)
    {
        string name = string.Join('.', chunk.Texts(3));
        long first = Math.Min(chunk.Number(9) ?? -1, chunk.Number(11) ?? long.MaxValue);
        long size = chunk.Number(7) ?? -1;
        if (chunk.Number(4) is not (Uncompressed or Zstd) || first < begin || size < 0 || first > end - size)
        {
            throw new DatasetFormatException($"the column '{name}' is not in the file, or not compressed as the format has it.");
        }

        byte[] header = new byte[(int)Math.Min(size, MaxPageHeaderBytes)];
        long values = 0;
        for (long at = first; at < first + size; )
        {
            file.Seek(at, SeekOrigin.Begin);
            int read = file.ReadAtLeast(header, (int)Math.Min(header.Length, first + size - at), throwOnEndOfStream: false);
            var reader = new ThriftReader(header.AsSpan(0, read));
            ThriftStruct page = reader.Struct();
            long stored = page.Number(3) ?? -1;
            long whole = page.Number(2) ?? -1;
            if (++pages > MaxPages || stored < 0 || whole is < 0 or > MaxPageBytes || at + reader.Position + stored > first + size)
            {
                throw new DatasetFormatException($"a page of the column '{name}' does not fit into it.");
            }

            values += page.Struct(5)?.Number(1) ?? page.Struct(8)?.Number(1) ?? 0;
            at += reader.Position + stored;
        }

        if (values != chunk.Number(5))
        {
            throw new DatasetFormatException($"the pages of the column '{name}' have {values} values instead of {chunk.Number(5)}.");
        }

        return first + size;
    }
}
