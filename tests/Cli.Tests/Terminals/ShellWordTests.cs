using Harvester.Runs.Supervising;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Terminals;

public sealed class ShellWordTests
{
    [Theory]
    [InlineData("out/drive-1.2_x", "out/drive-1.2_x")]
    [InlineData("out/drive-1", "out/drive-1")]
    [InlineData("my drives", "'my drives'")]
    [InlineData("it's", @"'it'\''s'")]
    [InlineData("a;rm", "'a;rm'")]
    [InlineData("$HOME", "'$HOME'")]
    [InlineData("", "''")]
    public void Quoted_argument_is_one_word_of_a_posix_shell(string word, string expected) =>
        Assert.Equal(expected, ShellWord.Of(word, isWindows: false));

    [Theory]
    [InlineData(@"C:\drives\1", @"C:\drives\1")]
    [InlineData(@"C:\my drives", "\"C:\\my drives\"")]
    public void Quoted_argument_is_one_word_on_windows(string word, string expected) =>
        Assert.Equal(expected, ShellWord.Of(word, isWindows: true));

    [PosixTheory]
    [InlineData("it's a \"test\" of $HOME; `x` \\ & * ~")]
    public void Quoted_argument_is_read_back_by_a_posix_shell(string word)
    {
        var start = new System.Diagnostics.ProcessStartInfo("/bin/sh") { RedirectStandardOutput = true };
        Array.ForEach(["-c", $"printf %s {ShellWord.Of(word, isWindows: false)}"], start.ArgumentList.Add);
        using System.Diagnostics.Process shell = System.Diagnostics.Process.Start(start)!;

        Assert.Equal(word, shell.StandardOutput.ReadToEnd());
    }
}
