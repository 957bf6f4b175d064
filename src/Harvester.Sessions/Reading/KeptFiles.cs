using System.Text.Json;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Scenarios;

namespace Harvester.Sessions.Reading;

/// <summary>The files that all scenes of a session share: the roads and the table of faces.</summary>
internal static class KeptFiles
{
    /// <summary>The roads; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message names the place in it.</exception>
    public static RoadNetwork? ReadRoads(SessionReader session)
    {
        string path = session.PathOf(FramePaths.Roads);
        if (!File.Exists(path))
        {
            return null;
        }

        try
        {
            using TextReader text = InputFile.OpenText(path);
            return RoadCsvReader.Read(text);
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException(e.Message, e);
        }
    }

    /// <summary>The record of a staged scenario; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">The file is not JSON; the message names the place in it.</exception>
    public static string? ReadScenario(SessionReader session)
    {
        string path = session.PathOf(ScenarioRecord.FileName);
        if (!File.Exists(path))
        {
            return null;
        }

        try
        {
            string text = InputFile.ReadAllText(path);
            using JsonDocument document = JsonInput.Parse(text);
            return text;
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InText(e), e);
        }
    }

    /// <summary>The table of faces; null if the session has none.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message names the place in it.</exception>
    public static FaceTable? ReadFaces(SessionReader session)
    {
        string path = session.PathOf(FramePaths.Faces);
        if (!File.Exists(path))
        {
            return null;
        }

        using TextReader text = InputFile.OpenText(path);
        FaceTableContent content = FaceTableReader.Read(text);
        return content.Problems.Count == 0 ? content.Table : throw new DatasetFormatException(content.Problems[0].ToString());
    }
}
