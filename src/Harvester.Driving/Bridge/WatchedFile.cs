using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Driving.Bridge;

/// <summary>A small text file that another process rewrites repeatedly; each version is read once. Its size is limited.</summary>
internal sealed class WatchedFile(string path)
{
    private const int MaxBytes = 65_536;

    /// <summary>A writer may keep the file locked for a moment.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);

    private readonly Stopwatch _unreadable = new();
    private (DateTime Written, long Length)? _seen;
    private (DateTime Written, long Length)? _failed;

    /// <summary>Marks the file's current content as seen, so that only a later version counts.</summary>
    /// <returns>Whether the content was new.</returns>
    public bool TrySee()
    {
        if (Version() is not { } version || version == _seen)
        {
            return false;
        }

        _seen = version;
        return true;
    }

    /// <summary>Reads the file if it has been written since the last call.</summary>
    /// <returns>False if it has not, does not exist, or is being written right now.</returns>
    /// <exception cref="BridgeException">The file is too large, or has been unreadable for long; thrown once for each version.</exception>
    public bool TryReadNew([NotNullWhen(true)] out string? text)
    {
        text = null;
        if (Version() is not { } version || version == _seen)
        {
            return false;
        }

        if (Read(out string? fault) is not { } bytes)
        {
            Fail(version, fault);
            return false;
        }

        if (Version() != version)
        {
            // The file has been written again meanwhile; the next call reads that.
            return false;
        }

        _seen = version;
        _failed = null;
        if (bytes.Length > MaxBytes)
        {
            throw new BridgeException(
                FormattableString.Invariant($"{Path.GetFileName(path)} is too large; at most {MaxBytes} bytes are read.")
            );
        }

        using var reader = new StreamReader(bytes, Encoding.UTF8);
        text = reader.ReadToEnd();
        return true;
    }

    private (DateTime Written, long Length)? Version()
    {
        var file = new FileInfo(path);
        return file.Exists ? (file.LastWriteTimeUtc, file.Length) : null;
    }

    /// <summary>The file's content, or one byte more than the limit; null if the file cannot be read now.</summary>
    private MemoryStream? Read(out string? fault)
    {
        fault = null;
        try
        {
            using FileStream file = RegularFile.OpenRead(path, FileShare.ReadWrite | FileShare.Delete);
            byte[] bytes = new byte[MaxBytes + 1];
            int length = 0;
            for (int read = -1; read != 0; length += read)
            {
                read = file.Read(bytes, length, bytes.Length - length);
            }

            return new MemoryStream(bytes, 0, length);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            fault = e.Message;
            return null;
        }
    }

    private void Fail((DateTime Written, long Length) version, string? fault)
    {
        if (version != _failed)
        {
            _failed = version;
            _unreadable.Restart();
        }
        else if (_unreadable.IsRunning && _unreadable.Elapsed > Patience)
        {
            _unreadable.Stop();
            throw new BridgeException($"{Path.GetFileName(path)} cannot be read: {fault}");
        }
    }
}
