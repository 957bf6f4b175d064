using System.IO;
using Harvester.Capture.Spaces;
using Harvester.Capture.Spaces.Survey;
using Harvester.Datasets;

namespace Harvester.Cli.Spaces;

/// <summary>Reads tables of spaces of interest from files.</summary>
internal static class SpaceFile
{
    /// <summary>The table that is meant: a survey's folder stands for the table in it.</summary>
    public static string TableOf(string path) => Directory.Exists(path) ? Path.Combine(path, SurveyFolder.TableName) : path;

    /// <summary>The good rows and why the others were refused.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static SpaceTableContent Read(string path)
    {
        using StreamReader text = File.OpenText(TableOf(path));
        return SpaceTableReader.Read(text);
    }

    /// <summary>A table as it is read again when it has been written, with corners to the millimetre.</summary>
    public static SpaceTable AsWritten(SpaceTable table) => SpaceTableReader.Read(new StringReader(SpaceTableWriter.Text(table))).Table;

    /// <summary>A table of which every row is good: a harvest shall not go on with some of them left out.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">A row is refused.</exception>
    public static SpaceTable ReadWhole(string path)
    {
        SpaceTableContent content = Read(path);
        return content.Problems.Count == 0
            ? content.Table
            : throw new DatasetFormatException($"{path}: {content.Problems.Count} rows are refused, the first at {content.Problems[0]} See 'harvester spaces check'.");
    }
}
