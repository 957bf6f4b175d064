using Harvester.Sessions.Files;
using Microsoft.Win32.SafeHandles;

namespace Harvester.Sessions.Tests.Files;

public sealed class AtomicFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-atomic").FullName;

    private string Target => PathOf("labels.jsonl");

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Write_replaces_the_older_file_and_leaves_no_other(bool isDurable)
    {
        File.WriteAllText(Target, "an older and longer text");

        AtomicFile.Write(Target, stream => stream.Write("new"u8), isDurable);

        Assert.Equal("new", File.ReadAllText(Target));
        Assert.Equal([Target], Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public void Text_has_no_byte_order_mark_and_keeps_its_line_ends()
    {
        AtomicFile.Write(Target, "ä\n\r\n");

        Assert.Equal("ä\n\r\n"u8, File.ReadAllBytes(Target));
    }

    [Fact]
    public void File_has_its_old_content_until_the_new_one_is_complete()
    {
        File.WriteAllText(Target, "old");

        AtomicFile.Write(
            Target,
            stream =>
            {
                stream.Write("new"u8);
                stream.Flush();
                Assert.Equal("old", File.ReadAllText(Target));
                Assert.Equal("labels.jsonl", AtomicFile.TargetOf(Path.GetFileName(Temporaries().Single())));
            }
        );
    }

    [Fact]
    public void Write_that_fails_leaves_the_old_file_and_nothing_else()
    {
        File.WriteAllText(Target, "old");

        Assert.Throws<InvalidDataException>(() =>
            AtomicFile.Write(
                Target,
                stream =>
                {
                    stream.Write("ne"u8);
                    throw new InvalidDataException();
                }
            )
        );

        Assert.Equal("old", File.ReadAllText(Target));
        Assert.Equal([Target], Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public void Write_over_a_folder_fails_and_leaves_only_the_folder()
    {
        Directory.CreateDirectory(Target);

        Exception refused = Assert.ThrowsAny<Exception>(() => AtomicFile.Write(Target, "new"));

        Assert.True(refused is IOException or UnauthorizedAccessException, refused.ToString());
        Assert.Equal([Target], Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public void Write_replaces_a_link_without_following_it()
    {
        string secret = PathOf("secret");
        File.WriteAllText(secret, "mine");
        File.CreateSymbolicLink(Target, secret);

        AtomicFile.Write(Target, "new");

        Assert.Equal("mine", File.ReadAllText(secret));
        Assert.Null(new FileInfo(Target).LinkTarget);
        Assert.Equal("new", File.ReadAllText(Target));
    }

    [Fact]
    public void Link_planted_at_the_temporary_name_is_not_followed()
    {
        string secret = PathOf("secret");
        File.WriteAllText(secret, "mine");

        Assert.ThrowsAny<IOException>(() => AtomicFile.Fill(Planted(secret), stream => stream.Write("new"u8), isDurable: false));

        Assert.Equal("mine", File.ReadAllText(secret));
    }

    [Fact]
    public void Temporary_names_are_unique_and_give_their_target()
    {
        string[] names = [.. Enumerable.Range(0, 1000).Select(_ => AtomicFile.TemporaryFor("a/spaces.csv"))];

        Assert.Equal(names.Length, names.Distinct().Count());
        Assert.All(names, name => Assert.Equal("a/spaces.csv", AtomicFile.TargetOf(name)));
        Assert.All(
            ["a.partial", ".0123456789abcdef.partial", "a.0123456789abcde.partial", "a.0123456789abcdef.png"],
            name => Assert.Null(AtomicFile.TargetOf(name))
        );
    }

    [Fact]
    public void First_of_two_writers_of_a_new_file_succeeds()
    {
        Assert.True(AtomicFile.TryWriteNew(Target, "first"));
        Assert.False(AtomicFile.TryWriteNew(Target, "second"));

        Assert.Equal("first", File.ReadAllText(Target));
        Assert.Equal([Target], Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public void Leftovers_of_other_targets_are_kept()
    {
        string[] others = ["notes.partial", "theirs.txt.0123456789abcdef.partial", "mine.txt"];
        foreach (string name in others.Append("mine.txt.0123456789abcdef.partial"))
        {
            File.WriteAllText(PathOf(name), "");
        }

        AtomicFile.DeleteLeftovers(_folder, target => target == "mine.txt");

        Assert.Equal(
            others.Order(StringComparer.Ordinal),
            Directory.GetFiles(_folder).Select(Path.GetFileName).Order(StringComparer.Ordinal)
        );
    }

    [Fact]
    public void CheckClose_throws_the_error_of_closing()
    {
        if (OperatingSystem.IsWindows())
        {
            // It reports such errors when a file is flushed.
            return;
        }

        using var closed = new SafeFileHandle(new IntPtr(int.MaxValue), ownsHandle: false);

        Assert.Throws<IOException>(() => DiskSync.CheckClose(closed));
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private string PathOf(string name) => Path.Combine(_folder, name);

    private IEnumerable<string> Temporaries() => Directory.GetFiles(_folder).Where(path => path != Target);

    private string Planted(string target)
    {
        string link = AtomicFile.TemporaryFor(Target);
        File.CreateSymbolicLink(link, target);
        return link;
    }
}
