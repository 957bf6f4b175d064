using System;
using System.IO;
using System.Text;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Surveys.Roads;

/// <summary>Keeps a survey's findings in a file of the form of <see cref="RoadCsv"/>.</summary>
public static class RoadSurveyFile
{
    /// <summary>What an earlier survey found; null when there is no file.</summary>
    /// <exception cref="FormatException">The file is damaged; the message says in which line.</exception>
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

    /// <summary>Writes the findings. The file is always a whole survey.</summary>
    /// <exception cref="IOException">The file cannot be written; one that was there before is as it was.</exception>
    public static void Save(string path, RoadNetwork network) => AtomicFile.Write(path, stream =>
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), 4096, leaveOpen: true);
        RoadCsvWriter.Write(network, text);
    });
}
