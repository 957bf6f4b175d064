using System;
using System.IO;
using System.IO.Compression;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Writes road networks to files of the project's own form.</summary>
public static class RoadWriter
{
    /// <summary>Writes a network: packed by gzip when the name ends in .gz. The file appears whole or not at all.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(RoadNetwork network, string path)
    {
        ArgumentNullException.ThrowIfNull(network);
        ArgumentException.ThrowIfNullOrEmpty(path);
        AtomicFile.Write(path, file =>
        {
            using Stream? packed = path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase)
                ? new GZipStream(file, CompressionLevel.Optimal, leaveOpen: true) : null;
            using var writer = new StreamWriter(packed ?? file, leaveOpen: true);
            RoadCsvWriter.Write(network, writer);
        });
    }
}
