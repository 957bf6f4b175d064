using Harvester.Sessions.Reading.Json;
using Parquet;
using Parquet.Schema;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// Writes a table as a Parquet file, row group by row group, so that a table of any length needs the memory of one group.
/// </summary>
internal static class ParquetTable
{
    /// <summary>Rows of a group: readers skip groups by their statistics, and a group of the widest table takes 30 MB.</summary>
    public const int RowsOfGroup = 32_768;

    /// <summary>The key of the metadata that describe the columns.</summary>
    public const string ColumnsKey = "gtaharvest.columns";

    /// <summary>The key of the metadata that say what a row is.</summary>
    public const string RowsKey = "gtaharvest.rows";

    /// <summary>Writes a table.</summary>
    /// <param name="table">The table.</param>
    /// <param name="stream">The file.</param>
    /// <param name="parts">Its rows, as <see cref="RowEncoder"/> has them.</param>
    public static void Write(LabelTable table, Stream stream, IEnumerable<string> parts)
    {
        ColumnBuffer[] columns = [.. table.Columns.Select(ColumnBuffer.Of)];
        var options = new ParquetOptions
        {
            CompressionMethod = CompressionMethod.Zstd,
            CompressionLevel = System.IO.Compression.CompressionLevel.Fastest,
        };
        foreach (TableColumn column in table.Columns.Where(column => column.Kind == ColumnKind.Word))
        {
            options.ColumnEncodingHints[column.Name] = EncodingHint.Dictionary;
        }

        using var counted = new ForwardStream(stream);
        var schema = new ParquetSchema(columns.Select(column => column.Field));
        ParquetWriter writer = ParquetWriter.CreateAsync(schema, counted, options).GetAwaiter().GetResult();
        writer.CustomMetadata = new Dictionary<string, string> { [RowsKey] = table.Meaning, [ColumnsKey] = Describe(table) };
        int rows = 0;
        foreach (string part in parts)
        {
            RowDecoder row = RowDecoder.Of(part);
            while (!row.IsAtEnd)
            {
                foreach (ColumnBuffer column in columns)
                {
                    column.Take(ref row);
                }

                if (++rows == RowsOfGroup)
                {
                    WriteGroup(writer, columns);
                    rows = 0;
                }
            }
        }

        if (rows > 0)
        {
            WriteGroup(writer, columns);
        }

        writer.DisposeAsync().AsTask().GetAwaiter().GetResult();
    }

    /// <summary>Units and fields of the columns as JSON.</summary>
    private static string Describe(LabelTable table) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            foreach (TableColumn column in table.Columns.Where(column => column.Unit.Length + column.Field.Length > 0))
            {
                json.WriteStartObject(column.Name);
                json.WriteString("unit", column.Unit);
                json.WriteString("field", column.Field);
                json.WriteEndObject();
            }

            json.WriteEndObject();
        });

    private static void WriteGroup(ParquetWriter writer, ColumnBuffer[] columns)
    {
        using ParquetRowGroupWriter group = writer.CreateRowGroup();
        foreach (ColumnBuffer column in columns)
        {
            column.Write(group);
        }

        group.CompleteValidate();
    }
}
