using Harvester.Datasets.Files;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Tests.Files;

public sealed class FolderReplacementTests : IDisposable
{
    private readonly string _parent = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public FolderReplacementTests() => Write(Target, "old");

    private string Target => Path.Combine(_parent, "out");

    public void Dispose() => Directory.Delete(_parent, recursive: true);

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Complete_replacement_leaves_only_the_new_folder(bool exchanges)
    {
        using FolderReplacement replacement = FolderReplacement.Begin(Target, exchanges);
        Write(replacement.Folder, "new");
        Assert.Equal("old", Read());

        Assert.Null(replacement.Complete());

        Assert.Equal("new", Read());
        Assert.Equal([Target], Directory.GetFileSystemEntries(_parent));
    }

    [Fact]
    public void Replacement_that_is_not_completed_changes_nothing()
    {
        using (FolderReplacement replacement = FolderReplacement.Begin(Target))
        {
            Write(replacement.Folder, "new");
        }

        Assert.Equal("old", Read());
        Assert.Equal([Target], Directory.GetFileSystemEntries(_parent));
    }

    [Theory]
    [InlineData(false, "old")]
    [InlineData(true, "new")]
    public void Lock_recovers_what_was_stopped_between_two_renames(bool isPlaced, string expected)
    {
        string container = Container();
        Directory.Move(Target, Path.Combine(container, "out.former"));
        if (isPlaced)
        {
            Directory.Move(Path.Combine(container, "out"), Target);
        }

        FolderLock.Take(Target).Dispose();

        Assert.Equal(expected, Read());
        Assert.Equal([Target], Directory.GetFileSystemEntries(_parent));
    }

    [Fact]
    public void Lock_deletes_a_replacement_that_was_stopped_before_it_began()
    {
        Directory.CreateDirectory(AtomicFile.TemporaryFor(Target));

        FolderLock.Take(Target).Dispose();

        Assert.Equal([Target], Directory.GetFileSystemEntries(_parent));
    }

    [Fact]
    public void Folder_without_a_mark_is_never_deleted()
    {
        string other = AtomicFile.TemporaryFor(Target);
        Write(other, "mine");

        FolderLock.Take(Target).Dispose();

        Assert.True(Directory.Exists(other));
    }

    [Fact]
    public void Folder_behind_a_link_is_replaced_where_it_is()
    {
        string link = Path.Combine(_parent, "link");
        Directory.CreateSymbolicLink(link, Target);
        using FolderReplacement replacement = FolderReplacement.Begin(link);
        Write(replacement.Folder, "new");

        replacement.Complete();

        Assert.Equal("new", Read());
        Assert.NotNull(new DirectoryInfo(link).LinkTarget);
    }

    private static void Write(string folder, string text)
    {
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, "file"), text);
    }

    private string Read() => File.ReadAllText(Path.Combine(Target, "file"));

    private string Container()
    {
        string container = AtomicFile.TemporaryFor(Target);
        Directory.CreateDirectory(container);
        UnfinishedMark.Write(container, "replacement of out");
        Write(Path.Combine(container, "out"), "new");
        return container;
    }
}
