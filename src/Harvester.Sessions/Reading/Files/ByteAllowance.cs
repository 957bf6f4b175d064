namespace Harvester.Sessions.Reading.Files;

/// <summary>Limit of the total unpacked size of all files of an import, because an archive can have any number of small bombs.</summary>
internal sealed class ByteAllowance(long bytes)
{
    private long _used;

    /// <exception cref="DatasetFormatException">The limit is exceeded.</exception>
    public void Use(string file, long count)
    {
        _used += count;
        if (_used > bytes)
        {
            throw new DatasetFormatException($"{file}: the unpacked files exceed the limit of {bytes} bytes.");
        }
    }
}
