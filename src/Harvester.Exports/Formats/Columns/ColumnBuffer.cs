using Parquet;
using Parquet.Schema;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The values of a column until a row group is full.</summary>
internal abstract class ColumnBuffer
{
    /// <summary>The column in the schema of the file.</summary>
    public abstract Field Field { get; }

    /// <summary>Makes the buffer of a column.</summary>
    public static ColumnBuffer Of(TableColumn column) =>
        column.Kind switch
        {
            ColumnKind.Integer or ColumnKind.Integers => new TypedBuffer<int>(column, static (ref RowDecoder row) => row.Integer()),
            ColumnKind.Long => new TypedBuffer<long>(column, static (ref RowDecoder row) => row.Long()),
            ColumnKind.Number or ColumnKind.Numbers => new TypedBuffer<double>(column, static (ref RowDecoder row) => row.Number()),
            ColumnKind.Truth => new TypedBuffer<bool>(column, static (ref RowDecoder row) => row.Truth()),
            _ => new TypedBuffer<ReadOnlyMemory<char>>(column, static (ref RowDecoder row) => row.Text().AsMemory()),
        };

    /// <summary>Takes the next value of a row.</summary>
    public abstract void Take(ref RowDecoder row);

    /// <summary>Writes the values to a row group, and forgets them.</summary>
    public abstract void Write(ParquetRowGroupWriter group);
}
