using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// Keeps a second process from writing to a folder. The lock is a file beside the folder that the system holds locked for this process, so
/// that it ends with the process, however that ends; a text beside it says who holds it. Both are gone when the lock is released. Where
/// nothing can be written beside the folder, or the file system has no locks, there is none.
/// </summary>
public sealed class FolderLock : IDisposable
{
    private const string Suffix = ".harvester-lock";

    // Of the file that was opened, another process may have taken the name away just then.
    private const int MaxTries = 3;

    // EWOULDBLOCK on Linux and macOS; a sharing and a lock violation on Windows.
    private static readonly int[] HeldByAnother = [11, 35, unchecked((int)0x80070020), unchecked((int)0x80070021)];

    private readonly string _path;
    private readonly Stack<string> _made;
    private readonly FileStream? _file;

    private FolderLock(string path, Stack<string> made, FileStream? file)
    {
        _path = path;
        _made = made;
        _file = file;
    }

    /// <summary>Locks a folder, which need not exist.</summary>
    /// <param name="folder">The folder that is to be written to.</param>
    /// <param name="part">The part of it that is written, where several processes may write a part each; empty for the whole.</param>
    /// <exception cref="OccupiedFolderException">Another process writes to it.</exception>
    public static FolderLock Take(string folder, string part = "")
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder));
        string parent = Path.GetDirectoryName(full) ?? full;
        string path = Path.Combine(parent, $".{Path.GetFileName(full)}{part}{Suffix}");
        var made = new Stack<string>();
        try
        {
            MakeFolder(parent, made);
            var taken = new FolderLock(path, made, Open(path));
            AtomicFile.Write(OwnerOf(path), string.Create(
                CultureInfo.InvariantCulture,
                $"process {Environment.ProcessId} on {Environment.MachineName} since {DateTime.UtcNow:yyyy-MM-dd HH:mm:ss} UTC\n"));
            return taken;
        }
        catch (IOException e) when (Array.IndexOf(HeldByAnother, e.HResult) >= 0)
        {
            throw new OccupiedFolderException(
                $"'{folder}' is being written by another harvester{OwnerIn(OwnerOf(path))}. "
                + "Wait until it has ended, or name another folder.");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A folder beside which nothing can be written is used without a lock; if it cannot be written either, the command says so.
            return new FolderLock(path, made, null);
        }
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose()
    {
        if (_file is not null)
        {
            DeleteQuietly(OwnerOf(_path));

            // Windows does not delete an open file; elsewhere another process could open it between closing and deleting.
            if (!OperatingSystem.IsWindows())
            {
                DeleteQuietly(_path);
            }

            _file.Dispose();
            if (OperatingSystem.IsWindows())
            {
                DeleteQuietly(_path);
            }
        }

        while (_made.TryPop(out string? folder))
        {
            DeleteIfEmpty(folder);
        }
    }

    private static string OwnerOf(string path) => path + ".txt";

    private static FileStream Open(string path)
    {
        FileStream file = OpenOnce(path);
        for (int i = 0; i < MaxTries; i++)
        {
            try
            {
                FileStream other = OpenOnce(path);
                file.Dispose();
                file = other;
            }
            catch (IOException e) when (Array.IndexOf(HeldByAnother, e.HResult) >= 0)
            {
                // The name still leads to the file that is held.
                return file;
            }
        }

        return file;
    }

    private static FileStream OpenOnce(string path)
    {
        if (new FileInfo(path).LinkTarget is not null)
        {
            File.Delete(path);
        }

        return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
    }

    private static void MakeFolder(string folder, Stack<string> made)
    {
        var missing = new Stack<string>();
        for (string? each = folder; each is not null && !Directory.Exists(each); each = Path.GetDirectoryName(each))
        {
            missing.Push(each);
        }

        while (missing.TryPop(out string? each))
        {
            Directory.CreateDirectory(each);
            made.Push(each);
        }
    }

    private static string OwnerIn(string path)
    {
        try
        {
            return $" ({File.ReadAllText(path).Trim()})";
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It has only just begun, or has just ended.
            return "";
        }
    }

    private static void DeleteQuietly(string path)
    {
        try
        {
            File.Delete(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The next that locks the folder uses the file again.
        }
    }

    private static void DeleteIfEmpty(string folder)
    {
        try
        {
            Directory.Delete(folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It holds what the command has written.
        }
    }
}
