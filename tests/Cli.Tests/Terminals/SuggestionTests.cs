using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Terminals;

public sealed class SuggestionTests
{
    [Theory]
    [InlineData("'harvest'", "harvset")]
    [InlineData("'--frames'", "harvest", "--out", "x", "--frame", "3")]
    [InlineData("'--weather'", "harvest", "--out", "x", "--wether=rain")]
    [InlineData("'--out'", "harvest", "--output", "x")]
    [InlineData("'--out'", "harvest", "-o", "x")]
    [InlineData("'--out'", "harvest", "out")]
    [InlineData("'--out'", "export", "x", "--OUT", "y")]
    [InlineData("'--quiet'", "harvest", "--out", "x", "--queit")]
    [InlineData("'compare'", "roads", "compaer")]
    [InlineData("'--help'", "validate", "x", "--hepl")]
    public void Mistyped_word_gets_the_nearest_name(string expected, params string[] arguments) =>
        CliRun.Of(arguments).AssertFailed(ExitCode.Usage, $"Did you mean {expected}?");

    [Fact]
    public void Word_unlike_any_name_gets_no_suggestion()
    {
        CliRun run = CliRun.Of("harvest", "--out", "x", "--zzzzzzz");

        run.AssertFailed(ExitCode.Usage, "Unrecognised argument '--zzzzzzz'. See 'harvester harvest --help'.");
    }

    [Theory]
    [InlineData("", "abc", 3)]
    [InlineData("frames", "frames", 0)]
    [InlineData("frame", "frames", 1)]
    [InlineData("farmes", "frames", 1)]
    [InlineData("kitten", "sitting", 3)]
    public void Mistakes_counts_inserted_missing_wrong_and_swapped_letters(string a, string b, int expected)
    {
        Assert.Equal(expected, Suggestion.Mistakes(a, b));
        Assert.Equal(expected, Suggestion.Mistakes(b, a));
    }
}
