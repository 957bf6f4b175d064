using System;
using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using System.IO;
using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Driving.Bridge;

/// <summary>
/// A small text file that somebody else writes again and again; each writing is read once. Never more is read than it may hold.
/// </summary>
internal sealed class WatchedFile(string path)
{
    private const int MaxBytes = 65_536;

    /// <summary>A writer may keep a file to itself for a moment.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);

    private readonly Stopwatch _unreadable = new();
    private (DateTime Written, long Length)? _seen;
    private (DateTime Written, long Length)? _failed;

    /// <summary>Takes what stands in the file now for seen, so that only a later writing counts.</summary>
    /// <returns>Whether it was new.</returns>
    public bool TrySee()
    {
        if (Version() is not { } version || version == _seen)
        {
            return false;
        }

        _seen = version;
        return true;
    }

    /// <summary>Reads the file if it has been written since the last time.</summary>
    /// <returns>False when it has not, is not there, or is being written just now.</returns>
    /// <exception cref="BridgeException">It is too large to be what it should be, or cannot be read for long; told once for each
    /// writing.</exception>
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
            // Another writing has come in between, and the next look reads that.
            return false;
        }

        _seen = version;
        _failed = null;
        if (bytes.Length > MaxBytes)
        {
            throw new BridgeException(
                FormattableString.Invariant($"{Path.GetFileName(path)} is too large; at most {MaxBytes} bytes are read."));
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

    /// <summary>What the file holds, or a byte more than it may; null when it cannot be read now.</summary>
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
