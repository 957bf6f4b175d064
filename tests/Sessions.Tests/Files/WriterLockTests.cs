using Harvester.Sessions.Files;

namespace Harvester.Sessions.Tests.Files;

/// <summary>The lock beside a folder that is written to.</summary>
public sealed class WriterLockTests : IDisposable
{
    private readonly string _parent = Directory.CreateTempSubdirectory("harvester-lock-").FullName;

    private string Folder => Path.Combine(_parent, "session");

    private string LockFile => Path.Combine(_parent, ".session.harvester-lock");

    public void Dispose() => Directory.Delete(_parent, recursive: true);

    [Fact]
    public void Second_lock_is_refused_and_names_the_owner()
    {
        using WriterLock first = WriterLock.Take(Folder);

        string message = Assert.Throws<FolderLockedException>(() => WriterLock.Take(Folder)).Message;

        Assert.Contains($"(process {Environment.ProcessId} on {Environment.MachineName} since ", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Lock_is_free_and_its_files_are_gone_when_it_is_released()
    {
        WriterLock.Take(Folder).Dispose();
        Assert.Empty(Directory.GetFileSystemEntries(_parent));

        WriterLock.Take(Folder).Dispose();
    }

    [Fact]
    public void Lock_of_a_killed_process_is_taken_over()
    {
        // What the system leaves of a process that is killed: the files, which nobody holds.
        File.WriteAllText(LockFile, "");
        File.WriteAllText(LockFile + ".txt", "process 1 on elsewhere since 2026-01-01 00:00:00 UTC\n");

        using WriterLock taken = WriterLock.Take(Folder);

        Assert.Contains($"process {Environment.ProcessId} ", File.ReadAllText(LockFile + ".txt"), StringComparison.Ordinal);
    }

    /// <summary>Windows holds a file that is open without sharing; the runtime does the same elsewhere by an advisory lock.</summary>
    [Fact]
    public void File_that_another_has_open_without_sharing_locks_the_folder()
    {
        using var held = new FileStream(LockFile, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None);

        Assert.Throws<FolderLockedException>(() => WriterLock.Take(Folder));
    }

    [Fact]
    public void Parts_of_a_folder_have_locks_of_their_own()
    {
        using WriterLock first = WriterLock.Take(Folder, "-1-of-2");
        using WriterLock second = WriterLock.Take(Folder, "-2-of-2");

        Assert.Throws<FolderLockedException>(() => WriterLock.Take(Folder, "-2-of-2"));
    }

    [Fact]
    public void Folder_named_with_a_separator_at_its_end_has_the_same_lock()
    {
        using WriterLock first = WriterLock.Take(Folder);

        Assert.Throws<FolderLockedException>(() => WriterLock.Take(Folder + Path.DirectorySeparatorChar));
    }
}
