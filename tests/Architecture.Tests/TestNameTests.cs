using System.Text.RegularExpressions;

namespace Harvester.Architecture.Tests;

/// <summary>The names of the tests of all projects, read from their sources.</summary>
public sealed partial class TestNameTests
{
    // As CONTRIBUTING.md requires: a longer name states more than one behaviour or is not read to its end.
    private const int MaxLength = 60;

    public static TheoryData<string> Projects =>
        new(
            Directory
                .EnumerateFiles(Path.Combine(Repository.Root, "tests"), "*.Tests.csproj", SearchOption.AllDirectories)
                .Select(path => Path.GetFileNameWithoutExtension(path)!)
                .Order(StringComparer.Ordinal)
        );

    [Theory]
    [MemberData(nameof(Projects))]
    public void Test_names_have_at_most_60_characters(string project)
    {
        string[] names = [.. Repository.SourcesOf(project, "tests").SelectMany(path => NamesIn(File.ReadAllText(path)))];

        string[] tooLong = [.. names.Where(name => name.Length > MaxLength)];

        Assert.NotEmpty(names);
        Assert.Empty(tooLong);
    }

    [Fact]
    public void Names_are_found_behind_any_attributes()
    {
        const string source = """
                [Fact]
                public void First() => Assert.True(true);

                [PosixTheory]
                [InlineData("a(b)")]
                [MemberData(nameof(Second))]
                public async Task Second(string text)

                public void Helper()
            """;

        Assert.Equal(["First", "Second"], NamesIn(source));
    }

    private static IEnumerable<string> NamesIn(string source) => Test().Matches(source).Select(match => match.Groups["name"].Value);

    // An attribute whose name ends with Fact or Theory, and the first public method after it.
    [GeneratedRegex(
        @"^[ ]*\[[\w, ]*(Fact|Theory)\b.*\n(?:(?![ ]*public ).*\n)*?[ ]*public (?:[\w<>]+ )+?(?<name>\w+)\(",
        RegexOptions.Multiline | RegexOptions.CultureInvariant
    )]
    private static partial Regex Test();
}
