namespace Harvester.Datasets.Files;

/// <summary>How many unpacked bytes all files of one import may have together: an archive can hold any number of small bombs.</summary>
internal sealed class ByteAllowance(long bytes)
{
    private long _used;

    /// <exception cref="DatasetFormatException">It is used up.</exception>
    public void Use(string file, long count)
    {
        _used += count;
        if (_used > bytes)
        {
            throw new DatasetFormatException($"{file}: the unpacked files exceed the limit of {bytes} bytes.");
        }
    }
}
