using System.Text;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>Reads the file of measured paint.</summary>
public static class MeasuredPaintFile
{
    /// <summary>Reads the paint of a road network.</summary>
    /// <param name="path">The file, in the format of <see cref="PaintCsv"/>.</param>
    /// <param name="network">The roads.</param>
    /// <exception cref="FormatException">The file is damaged, or belongs to other roads; the message names file and line.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PaintTable Load(string path, RoadNetwork network)
    {
        using var text = new StreamReader(path, Encoding.UTF8);
        try
        {
            return PaintCsvReader.Read(text, network);
        }
        catch (FormatException e)
        {
            throw new FormatException($"{path}: {e.Message}", e);
        }
    }
}
