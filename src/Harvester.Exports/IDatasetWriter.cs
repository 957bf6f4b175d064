using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports;

/// <summary>
/// Writes a dataset format. Output for a single frame goes into files of its own. Content of files for the whole dataset is written in
/// parts, which are assembled when all frames are done. A frame's output must depend on that frame only, so that shards and resumed exports
/// give the same bytes as a single run.
/// </summary>
public interface IDatasetWriter
{
    /// <summary>Writes a frame.</summary>
    /// <returns>The number of objects written; none in formats without objects.</returns>
    /// <exception cref="DatasetFormatException">The format cannot represent the frame.</exception>
    WrittenObjects Write(ExportFrame frame, FrameOutput output);

    /// <summary>The files to assemble at the end.</summary>
    /// <param name="parts">Names and numbers of the parts that frames wrote, in ordinal order.</param>
    IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts);

    /// <summary>Further files to assemble at the end, several in one pass over their parts.</summary>
    IEnumerable<AggregateTables> Tables => [];
}
