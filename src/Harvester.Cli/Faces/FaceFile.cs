using System;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Sessions.Faces;
using Harvester.Surveys.Faces;

namespace Harvester.Cli.Faces;

/// <summary>Reads tables of faces from files.</summary>
internal static class FaceFile
{
    private const int MaxReportedProblems = 5;

    // The column of a problem with a row that has not even the fields of one.
    private const string WholeRow = "row";

    /// <summary>The table that is meant: a survey's folder stands for the table in it.</summary>
    public static string TableOf(string path) => Directory.Exists(path) ? Path.Combine(path, SurveyFolder.TableName) : path;

    /// <summary>The good rows and why the others were refused.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">It is something else than a table.</exception>
    public static FaceTableContent Read(string path)
    {
        string table = TableOf(path);
        using TextReader text = InputFile.OpenText(table);
        FaceTableContent content = FaceTableReader.Read(text);
        return content.Table.Faces.Any() || IsTable(content, table)
            ? content
            : throw new DatasetFormatException($"'{table}' is no table of faces and heads: it has neither the header of one nor a row. data/README.md says what belongs there.");
    }

    /// <summary>A table as it is read again when it has been written, with corners to the millimetre.</summary>
    public static FaceTable AsWritten(FaceTable table) => FaceTableReader.Read(new StringReader(FaceTableWriter.Text(table))).Table;

    /// <summary>The good rows of a table; of the others the first few and their number are told.</summary>
    /// <param name="path">The table, or a survey's folder.</param>
    /// <param name="warn">Is told what is refused, a line at a time.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">It is something else than a table, or no row of it is good and some are
    /// refused.</exception>
    public static FaceTable ReadGood(string path, Action<string> warn)
    {
        FaceTableContent content = Read(path);
        int good = content.Table.Faces.Count();
        int refused = content.Problems.Count;
        if (refused == 0)
        {
            return content.Table;
        }

        if (good == 0)
        {
            throw new DatasetFormatException($"{path}: no row can be used; {refused} are refused, the first at {content.Problems[0]} See 'harvester spaces check'.");
        }

        foreach (FaceTableProblem problem in content.Problems.Take(MaxReportedProblems))
        {
            warn($"{path}: {problem}");
        }

        warn($"{path}: {refused} of the rows are refused, the other {good} are used. See 'harvester spaces check'.");
        return content.Table;
    }

    /// <summary>
    /// Whether a file without a good row is a table all the same: one with the header or bad rows, or with remarks alone.
    /// </summary>
    private static bool IsTable(FaceTableContent content, string table) => content.Problems switch
    {
        [] => InputFile.ReadLines(table).Any(line => line.Trim().Length > 0),
        [{ Column: not WholeRow }, ..] => true,
        _ => content.HasHeader,
    };
}
