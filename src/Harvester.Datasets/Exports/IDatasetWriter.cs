using System.Collections.Generic;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Exports;

/// <summary>
/// Writes one dataset format. What belongs to a single frame goes into files of its own; what a format gathers in one file for all frames
/// is handed over in parts, from which that file is put together when all frames are done. A frame's output depends on that frame
/// alone, so that shards and continued exports give the same bytes as a single run.
/// </summary>
public interface IDatasetWriter
{
    /// <summary>Writes one frame.</summary>
    /// <returns>How many of the frame's objects it has written; none in formats without objects.</returns>
    /// <exception cref="DatasetFormatException">The frame cannot be said in this format.</exception>
    WrittenObjects Write(ExportFrame frame, FrameOutput output);

    /// <summary>The files to put together in the end.</summary>
    /// <param name="parts">Names of the parts that frames handed over, in ordinal order, and how many there are of each.</param>
    IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts);
}
