using Harvester.Datasets.Roads.Sources;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Reads the project's own road files.</summary>
internal static class CsvImporter
{
    public static RoadImport Import(RoadSource source)
    {
        using TextReader reader = source.OpenText();
        try
        {
            return new RoadImport(RoadCsvReader.Read(reader), "CSV of this project", []);
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"{source.Name}, {e.Message}", e);
        }
    }
}
