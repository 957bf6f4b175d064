using System.IO.Compression;
using Harvester.Datasets.Files;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Writes road networks in the project's CSV format.</summary>
public static class RoadWriter
{
    /// <summary>Writes a network, gzip-compressed if the name ends in .gz. The file is written atomically.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(RoadNetwork network, string path)
    {
        ArgumentNullException.ThrowIfNull(network);
        ArgumentException.ThrowIfNullOrEmpty(path);
        OutputFile.Write(
            path,
            file =>
            {
                using Stream? packed = path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase)
                    ? new GZipStream(file, CompressionLevel.Optimal, leaveOpen: true)
                    : null;
                using var writer = new StreamWriter(packed ?? file, leaveOpen: true);
                RoadCsvWriter.Write(network, writer);
            }
        );
    }
}
