using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Parquet;
using Parquet.Schema;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// Checks the tables: files and pages are whole, columns are those of the format, frames stand once and in order with an image, and every
/// row belongs to a frame.
/// </summary>
internal sealed class ParquetDatasetCheck
{
    private readonly DatasetContent _dataset;
    private readonly HashSet<int> _frames = [];

    private ParquetDatasetCheck(DatasetContent dataset) => _dataset = dataset;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var check = new ParquetDatasetCheck(dataset);
        foreach (LabelTable table in LabelTables.All)
        {
            string? problem = null;
            try
            {
                problem = dataset.Has(table.FileName) ? check.ProblemOf(table) : "it is missing.";
            }
            catch (DatasetFormatException e)
            {
                problem = e.Message;
            }

            if (problem is not null)
            {
                yield return new SessionProblem(table.FileName, null, problem);
            }
        }
    }

    private string? ProblemOf(LabelTable table)
    {
        using FileStream file = InputFile.OpenRead(_dataset.PathOf(table.FileName));
        ParquetFooter footer = ParquetFooter.Read(file, ParquetTable.RowsOfGroup);
        if (!footer.Columns.SequenceEqual(table.Columns.Select(column => (column.Name, (long?)TypeOf(column.Kind)))))
        {
            return "its columns are not those of the format.";
        }

        file.Seek(0, SeekOrigin.Begin);
        try
        {
            return RowProblem(table, file);
        }
        catch (Exception e) when (e is not (DatasetFormatException or OutOfMemoryException or OperationCanceledException))
        {
            // The library throws whatever comes up when a page is not what its header says.
            return $"its pages cannot be read: {e.Message}";
        }
    }

    private string? RowProblem(LabelTable table, FileStream file)
    {
        ParquetReader reader = ParquetReader.CreateAsync(file, leaveStreamOpen: true).GetAwaiter().GetResult();
        DataField[] fields = reader.Schema.GetDataFields();
        DataField Field(string name) => fields.First(field => field.Path.ToString() == name);
        for (int i = 0; i < reader.RowGroupCount; i++)
        {
            ParquetRowGroupReader group = reader.OpenRowGroupReader(i);
            int[] frames = new int[group.RowCount];
            group.ReadAsync<int>(Field("frame"), frames).AsTask().GetAwaiter().GetResult();
            if (table != FrameTables.Frames)
            {
                if (frames.Any(frame => !_frames.Contains(frame)))
                {
                    int unknown = frames.First(frame => !_frames.Contains(frame));
                    return $"it has a row of frame {unknown}, which is not in {FrameTables.Frames.FileName}.";
                }

                continue;
            }

            string[] splits = new string[group.RowCount];
            string[] images = new string[group.RowCount];
            group.ReadAsync(Field("split"), splits).AsTask().GetAwaiter().GetResult();
            group.ReadAsync(Field("image"), images).AsTask().GetAwaiter().GetResult();
            for (int row = 0; row < frames.Length; row++)
            {
                if (frames[row] < 0 || !_frames.Add(frames[row]))
                {
                    return $"frame {frames[row]} is negative or stands twice.";
                }

                if (!_dataset.Splits.Contains(splits[row]))
                {
                    return $"frame {frames[row]} is in the split '{splits[row]}', which the export does not have.";
                }

                if (!_dataset.Has(images[row]))
                {
                    return $"frame {frames[row]} has no image '{images[row]}'.";
                }

                _dataset.Found(splits[row]);
            }
        }

        return null;
    }

    /// <summary>The number of the type in parquet.thrift.</summary>
    private static int TypeOf(ColumnKind kind) =>
        kind switch
        {
            ColumnKind.Truth => 0,
            ColumnKind.Integer or ColumnKind.Integers => 1,
            ColumnKind.Long => 2,
            ColumnKind.Number or ColumnKind.Numbers => 5,
            _ => 6,
        };
}
