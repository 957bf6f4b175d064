using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Faces;

/// <summary>Reads tables of faces from files.</summary>
internal static class FaceFile
{
    private const int MaxReportedProblems = 5;

    // The column of a problem with a row that has the wrong number of fields.
    private const string WholeRow = "row";

    /// <summary>The file of a table; for the folder of a survey, the table in it.</summary>
    public static string TableOf(string path) => Directory.Exists(path) ? Path.Combine(path, FaceTable.FileName) : path;

    /// <summary>The valid rows of a table, and the problems of the others.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">The file is not a table.</exception>
    public static FaceTableContent Read(string path)
    {
        string table = TableOf(path);
        using TextReader text = InputFile.OpenText(table);
        FaceTableContent content = FaceTableReader.Read(text);
        return content.Table.Faces.Any() || IsTable(content, table)
            ? content
            : throw new DatasetFormatException(
                $"'{table}' is not a table of faces: it has neither its header nor a valid row. data/README.md describes the format."
            );
    }

    /// <summary>A table as it is read back after writing, with corners rounded to the millimetre.</summary>
    public static FaceTable AsWritten(FaceTable table) => FaceTableReader.Read(new StringReader(FaceTableWriter.Text(table))).Table;

    /// <summary>The valid rows of a table; of the others, the number and the first few problems are reported.</summary>
    /// <param name="path">The table, or the folder of a survey.</param>
    /// <param name="warn">Receives the reports, one line each.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">The file is not a table, or all its rows are invalid.</exception>
    public static FaceTable ReadValid(string path, Action<string> warn)
    {
        FaceTableContent content = Read(path);
        int valid = content.Table.Faces.Count();
        int invalid = content.Problems.Count;
        if (invalid == 0)
        {
            return content.Table;
        }

        if (valid == 0)
        {
            throw new DatasetFormatException(
                $"{path}: all {invalid} rows are invalid. The first: {content.Problems[0]} See 'harvester spaces check'."
            );
        }

        foreach (FaceTableProblem problem in content.Problems.Take(MaxReportedProblems))
        {
            warn($"{path}: {problem}");
        }

        warn($"{path}: {invalid} of {invalid + valid} rows are invalid and are ignored. See 'harvester spaces check'.");
        return content.Table;
    }

    /// <summary>
    /// Whether a file without a valid row is a table nevertheless: it has the header, rows with invalid values, or only comments.
    /// </summary>
    private static bool IsTable(FaceTableContent content, string table) =>
        content.Problems switch
        {
            [] => InputFile.ReadLines(table).Any(line => line.Trim().Length > 0),
            [{ Column: not WholeRow }, ..] => true,
            _ => content.HasHeader,
        };
}
