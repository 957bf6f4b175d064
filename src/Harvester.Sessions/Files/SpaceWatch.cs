using System.Diagnostics;

namespace Harvester.Sessions.Files;

/// <summary>Watches the free space of the disk that is written to, so that writing stops in good order before the disk is full.</summary>
/// <param name="folder">The folder that is written.</param>
/// <param name="minFreeBytes">Space that is to stay free, bytes; 0 watches nothing.</param>
/// <param name="disk">The disk; null for that of the operating system.</param>
public sealed class SpaceWatch(string folder, long minFreeBytes, IFreeSpace? disk = null)
{
    // Asking takes microseconds, but the answer of a network disk may be slow. A fast disk takes half a gigabyte in this time.
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(250);

    private readonly IFreeSpace _disk = disk ?? new DriveSpace();
    private readonly Stopwatch _age = new();

    /// <summary>Looks at the disk, unless that was done a moment ago.</summary>
    /// <exception cref="LowSpaceException">Less space is free than is to stay free.</exception>
    public void Check()
    {
        if (minFreeBytes == 0 || (_age.IsRunning && _age.Elapsed < Interval))
        {
            return;
        }

        _age.Restart();
        if (_disk.BytesFor(folder) is { } free && free < minFreeBytes)
        {
            throw new LowSpaceException(
                FormattableString.Invariant(
                    $"The disk of '{folder}' has {free / 1e9:0.###} GB free; {minFreeBytes / 1e9:0.###} GB must stay free."
                )
            );
        }
    }
}
