using Harvester.Sessions.Files;

namespace Harvester.Sessions.Tests.Files;

public sealed class AppendedFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-append-").FullName;

    private string Labels => Path.Combine(_folder, "labels.jsonl");

    private string Secret => Path.Combine(_folder, "secret");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void File_is_made_and_appended_to()
    {
        foreach (byte line in "ab"u8.ToArray())
        {
            using FileStream file = AppendedFile.Open(Labels);
            file.WriteByte(line);
        }

        Assert.Equal("ab", File.ReadAllText(Labels));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Lines_are_appended_at_once(bool isDurable)
    {
        using FileStream file = AppendedFile.Open(Labels);

        AppendedFile.AppendLines(file, ["a", "ä"], isDurable);
        AppendedFile.AppendLines(file, ["b"], isDurable);

        using var shown = new StreamReader(new FileStream(Labels, FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        Assert.Equal("a\nä\nb\n", shown.ReadToEnd());
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Link_is_not_followed(bool isThere)
    {
        if (isThere)
        {
            File.WriteAllText(Secret, "mine");
        }

        File.CreateSymbolicLink(Labels, Secret);

        Assert.Contains("is a link", Assert.Throws<IOException>(() => AppendedFile.Open(Labels)).Message, StringComparison.Ordinal);
        Assert.Equal(isThere, File.Exists(Secret));
    }
}
