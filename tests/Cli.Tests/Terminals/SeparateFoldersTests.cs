using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Terminals;

public sealed class SeparateFoldersTests
{
    [Theory]
    [InlineData("one", "two")]
    [InlineData("one", "one-session")]
    [InlineData("one", null)]
    public void Folders_beside_each_other_are_accepted(string first, string? second) =>
        SeparateFolders.Check(("--out", first), ("--record", second));

    [Theory]
    [InlineData("one", "one/")]
    [InlineData("one", "two/../one")]
    public void Two_names_of_one_folder_are_refused(string first, string second)
    {
        UsageException refused = Assert.Throws<UsageException>(() => SeparateFolders.Check(("--out", first), ("--record", second)));

        Assert.Equal($"--out and --record name the same folder, '{second}'. Name a folder of its own for each.", refused.Message);
    }

    [Theory]
    [InlineData("one", "one/two", "--record", "--out")]
    [InlineData("one/two/three", "one", "--out", "--record")]
    [InlineData("one", "/", "--out", "--record")]
    public void Folder_inside_another_is_refused(string first, string second, string inner, string outer)
    {
        UsageException refused = Assert.Throws<UsageException>(() => SeparateFolders.Check(("--out", first), ("--record", second)));

        Assert.Matches($"^The folder of {inner}, '.+', is inside that of {outer}, '.+'\\. ", refused.Message);
    }

    [PosixFact]
    public void Folder_inside_another_through_a_link_is_refused()
    {
        using TemporaryFolder folder = new();
        Directory.CreateDirectory(folder.PathOf("real"));
        Directory.CreateSymbolicLink(folder.PathOf("link"), folder.PathOf("real"));

        Assert.Throws<UsageException>(() =>
            SeparateFolders.Check(("--out", folder.PathOf("real")), ("--record", folder.PathOf("link/session")))
        );
    }
}
