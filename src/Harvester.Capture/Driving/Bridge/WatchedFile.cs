using System;
using System.Diagnostics.CodeAnalysis;
using System.IO;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>A small text file that somebody else writes again and again; each writing is read once.</summary>
internal sealed class WatchedFile(string path)
{
    private const long LargestBytes = 65_536;

    private (DateTime Written, long Length) _seen;

    /// <summary>Takes what stands in the file now for seen, so that only a later writing counts.</summary>
    public void Ignore()
    {
        var file = new FileInfo(path);
        _seen = file.Exists ? (file.LastWriteTimeUtc, file.Length) : default;
    }

    /// <summary>Reads the file if it has been written since the last time.</summary>
    /// <returns>False when it has not, is not there, or is being written just now.</returns>
    /// <exception cref="BridgeException">It is too large to be what it should be.</exception>
    public bool TryReadNew([NotNullWhen(true)] out string? text)
    {
        text = null;
        var file = new FileInfo(path);
        if (!file.Exists || (file.LastWriteTimeUtc, file.Length) == _seen)
        {
            return false;
        }

        (DateTime, long) version = (file.LastWriteTimeUtc, file.Length);
        if (file.Length > LargestBytes)
        {
            _seen = version;
            throw new BridgeException(FormattableString.Invariant($"{file.Name} has {file.Length} bytes; at most {LargestBytes} are read."));
        }

        try
        {
            text = File.ReadAllText(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }

        _seen = version;
        return true;
    }
}
