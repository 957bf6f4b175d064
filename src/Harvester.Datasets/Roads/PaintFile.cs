using Harvester.Datasets.Files;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Reads and writes tables of measured paint.</summary>
public static class PaintFile
{
    /// <summary>Reads a table.</summary>
    /// <param name="path">The file.</param>
    /// <param name="network">The roads.</param>
    /// <exception cref="DatasetFormatException">The file is invalid, or belongs to other roads; the message names it.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PaintTable Read(string path, RoadNetwork network)
    {
        try
        {
            using TextReader text = InputFile.OpenText(path);
            return PaintCsvReader.Read(text, network);
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"{path}: {e.Message}", e);
        }
    }

    /// <summary>Writes a table, whole or not at all.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(PaintTable table, string path)
    {
        ArgumentNullException.ThrowIfNull(table);
        OutputFile.Write(
            path,
            file =>
            {
                using var writer = new StreamWriter(file, leaveOpen: true);
                PaintCsvWriter.Write(table, writer);
            }
        );
    }
}
