namespace Harvester.Exports.Pairs;

/// <summary>How the pictures of moments are exported.</summary>
public enum PairFormat
{
    /// <summary>A folder of pictures for each moment, and tables.</summary>
    Csv,

    /// <summary>Archives with one sample for each moment.</summary>
    Webdataset,
}
