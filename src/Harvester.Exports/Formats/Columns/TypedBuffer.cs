using Parquet;
using Parquet.Schema;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// The values of a column of one type. Parquet keeps known values only, and for each entry of a column a definition level: 0 for an unknown
/// value or list, 1 for a value or an empty list, 2 for an item of a list; and for lists a repetition level, 1 for items after the first.
/// </summary>
/// <typeparam name="T">The type of the values, or of a list's items.</typeparam>
internal sealed class TypedBuffer<T> : ColumnBuffer
    where T : struct
{
    private const int EmptyList = 1;
    private const int Item = 2;

    private readonly List<T> _values = [];
    private readonly List<int> _levels = [];
    private readonly List<int> _repetitions = [];
    private readonly Reading _read;
    private readonly DataField _data;
    private readonly bool _isList;
    private readonly bool _isRequired;

    /// <param name="column">The column.</param>
    /// <param name="read">Reads a value.</param>
    public TypedBuffer(TableColumn column, Reading read)
    {
        _read = read;
        _isRequired = column.IsRequired;
        _isList = column.Kind is ColumnKind.Integers or ColumnKind.Numbers or ColumnKind.Texts;
        Type type = typeof(T) == typeof(ReadOnlyMemory<char>) ? typeof(string) : typeof(T);
        _data = new DataField(_isList ? ListField.ElementName : column.Name, type, isNullable: !_isList && !_isRequired);
        Field = _isList ? new ListField(column.Name, _data) : _data;
    }

    /// <summary>Reads a value that is known.</summary>
    public delegate T Reading(ref RowDecoder row);

    public override Field Field { get; }

    public override void Take(ref RowDecoder row)
    {
        if (!row.IsKnown())
        {
            Level(_isRequired ? throw RowDecoder.Damaged() : 0, 0);
        }
        else if (!_isList)
        {
            _values.Add(_read(ref row));
            Level(1, 0);
        }
        else
        {
            int count = row.Integer();
            for (int i = 0; i < count; i++)
            {
                _values.Add(_read(ref row));
                Level(Item, i == 0 ? 0 : 1);
            }

            if (count == 0)
            {
                Level(EmptyList, 0);
            }
        }
    }

    public override void Write(ParquetRowGroupWriter group)
    {
        // The stream of a file is written synchronously, so the task is done when it is returned.
        group
            .WriteAllPartsAsync<T>(
                _data,
                _values.ToArray(),
                _isRequired ? (ReadOnlyMemory<int>?)null : _levels.ToArray(),
                _isList ? _repetitions.ToArray() : (ReadOnlyMemory<int>?)null,
                CancellationToken.None
            )
            .GetAwaiter()
            .GetResult();
        _values.Clear();
        _levels.Clear();
        _repetitions.Clear();
    }

    private void Level(int definition, int repetition)
    {
        _levels.Add(definition);
        if (_isList)
        {
            _repetitions.Add(repetition);
        }
    }
}
