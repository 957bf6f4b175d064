using System.Text;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>Stores a survey's result in a file of the format <see cref="RoadCsv"/>.</summary>
public static class RoadSurveyFile
{
    /// <summary>Reads the result of an earlier survey; null if there is no file.</summary>
    /// <exception cref="FormatException">The file is damaged; the message names the line.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static RoadNetwork? Load(string path)
    {
        if (!File.Exists(path))
        {
            return null;
        }

        using var text = new StreamReader(path, Encoding.UTF8);
        return RoadCsvReader.Read(text);
    }

    /// <summary>Writes the result. The file is always complete.</summary>
    /// <exception cref="IOException">The file cannot be written; an older one is unchanged.</exception>
    public static void Save(string path, RoadNetwork network) =>
        AtomicFile.Write(
            path,
            stream =>
            {
                using var text = new StreamWriter(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), 4096, leaveOpen: true);
                RoadCsvWriter.Write(network, text);
            }
        );
}
