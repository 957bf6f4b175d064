using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;

namespace Harvester.Sessions.Files;

/// <summary>
/// Keeps a second process from writing to a folder. The lock is a file beside the folder that the system holds locked for this process, so
/// that it ends with the process, however that ends; a text beside it says who holds it. Both are gone when the lock is released. Where
/// nothing can be written beside the folder, or the file system has no locks, there is none.
/// </summary>
public sealed class WriterLock : IDisposable
{
    private const string Suffix = ".harvester-lock";
    private const int MaxOwnerBytes = 1024;

    // Of the file that was opened, another process may have taken the name away just then.
    private const int MaxTries = 3;

    // EWOULDBLOCK on Linux and macOS; a sharing and a lock violation on Windows.
    private static readonly int[] HeldByAnother = [11, 35, unchecked((int)0x80070020), unchecked((int)0x80070021)];

    private static readonly HashSet<WriterLock> Held = [];

    private readonly string _path;
    private readonly Stack<string> _made;
    private FileStream? _file;

    private WriterLock(string path, Stack<string> made, FileStream? file)
    {
        _path = path;
        _made = made;
        _file = file;
    }

    /// <summary>Whether the folder is locked; false where no lock could be made beside it.</summary>
    public bool IsHeld => _file is not null;

    private static bool IsWindows => RuntimeInformation.IsOSPlatform(OSPlatform.Windows);

    /// <summary>Locks a folder, which need not exist.</summary>
    /// <param name="folder">The folder that is to be written to.</param>
    /// <param name="part">The part of it that is written, where several processes may write a part each; empty for the whole.</param>
    /// <exception cref="FolderLockedException">Another process writes to it.</exception>
    public static WriterLock Take(string folder, string part = "")
    {
        string full = Path.GetFullPath(folder);
        string trimmed = full.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
        string parent = Path.GetDirectoryName(trimmed) ?? full;
        string path = Path.Combine(parent, $".{Path.GetFileName(trimmed)}{part}{Suffix}");
        var made = new Stack<string>();
        try
        {
            MakeFolder(parent, made);
            var taken = new WriterLock(path, made, Open(path));
            taken.NameOwner();
            lock (Held)
            {
                Held.Add(taken);
            }

            return taken;
        }
        catch (IOException e) when (Array.IndexOf(HeldByAnother, e.HResult) >= 0)
        {
            throw new FolderLockedException(
                $"'{folder}' is being written by another harvester{OwnerIn(OwnerOf(path))}. "
                    + "Wait until it has ended, or name another output."
            );
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A folder beside which nothing can be written is used without a lock; if it cannot be written either, the command says so.
            return new WriterLock(path, made, null);
        }
    }

    /// <summary>
    /// Deletes the files of all locks that this process holds, because it is about to end without releasing them. To be called last.
    /// </summary>
    public static void AbandonAll()
    {
        lock (Held)
        {
            foreach (WriterLock held in Held)
            {
                DeleteQuietly(OwnerOf(held._path));
                DeleteQuietly(held._path);
            }
        }
    }

    /// <summary>Says who holds the lock; a lock without that text holds as well.</summary>
    private void NameOwner()
    {
        try
        {
            string owner = FormattableString.Invariant($"process {ProcessId()} on {Environment.MachineName} since {Now()} UTC\n");
            AtomicFile.Write(OwnerOf(_path), owner, isDurable: false);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            DeleteQuietly(OwnerOf(_path));
        }
    }

    /// <summary>Releases the folder for other writers.</summary>
    public void Dispose()
    {
        if (_file is not null)
        {
            lock (Held)
            {
                Held.Remove(this);
            }

            DeleteQuietly(OwnerOf(_path));

            // Windows does not delete an open file; elsewhere another process could open it between closing and deleting.
            if (!IsWindows)
            {
                DeleteQuietly(_path);
            }

            _file.Dispose();
            _file = null;
            if (IsWindows)
            {
                DeleteQuietly(_path);
            }
        }

        while (_made.Count > 0)
        {
            DeleteIfEmpty(_made.Pop());
        }
    }

    /// <summary>Whether a name is that of the lock of a file beside it, or of the text that says who holds it.</summary>
    /// <param name="name">The name.</param>
    /// <param name="file">The file or folder, with the part of it where it has locks for parts.</param>
    public static bool IsOf(string name, string file) => name == $".{file}{Suffix}" || name == OwnerOf($".{file}{Suffix}");

    private static string OwnerOf(string path) => path + ".txt";

    private static string Now() => DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm:ss", CultureInfo.InvariantCulture);

    private static int ProcessId()
    {
#if NET
        return Environment.ProcessId;
#else
        using var process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Id;
#endif
    }

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
            catch
            {
                file.Dispose();
                throw;
            }
        }

        return file;
    }

    private static FileStream OpenOnce(string path)
    {
        if (AppendedFile.IsLink(path))
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

        while (missing.Count > 0)
        {
            string each = missing.Pop();
            Directory.CreateDirectory(each);
            made.Push(each);
        }
    }

    private static string OwnerIn(string path)
    {
        try
        {
            using FileStream file = RegularFile.OpenRead(path, FileShare.ReadWrite | FileShare.Delete);
            byte[] text = new byte[MaxOwnerBytes];
            return $" ({Encoding.UTF8.GetString(text, 0, file.Read(text, 0, text.Length)).Trim()})";
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
