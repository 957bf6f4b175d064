namespace Harvester.Architecture.Tests;

/// <summary>Lines of code and comments fit into two columns of a wide screen.</summary>
public sealed class LineLengthTests
{
    private const int MaxColumns = 140;

    [Theory]
    [InlineData("src")]
    [InlineData("tests")]
    [InlineData("bench")]
    public void Lines_have_at_most_140_columns(string folder)
    {
        string[] files = [.. Repository.SourcesOf(string.Empty, folder)];
        string[] tooLong = [.. files.SelectMany(LongLinesOf)];

        Assert.NotEmpty(files);
        Assert.Empty(tooLong);
    }

    [Fact]
    public void Prose_of_the_docs_has_at_most_140_columns()
    {
        string[] pages =
        [
            .. Directory.EnumerateFiles(Repository.Root, "*.md"),
            .. Directory.EnumerateFiles(Path.Combine(Repository.Root, "docs"), "*.md", SearchOption.AllDirectories),
        ];
        string[] tooLong = [.. pages.SelectMany(LongProseOf)];

        Assert.NotEmpty(pages);
        Assert.Empty(tooLong);
    }

    [Fact]
    public void Tables_and_code_blocks_of_a_page_may_be_longer()
    {
        string text = new('a', MaxColumns + 1);
        string[] lines = [$"| {text} |", "```", text, "```", text];

        Assert.Equal([5], LongProse(lines));
    }

    [Fact]
    public void Only_the_content_of_raw_strings_may_be_longer()
    {
        string text = new('a', MaxColumns + 1);
        string[] lines = ["const string S = \"\"\"", text, "\"\"\";", "const string T = \"\"\"t\"\"\";", text];

        Assert.Equal([5], LongLines(lines));
    }

    private static IEnumerable<string> LongLinesOf(string path) => LongLines(File.ReadLines(path)).Select(number => PlaceOf(path, number));

    private static IEnumerable<string> LongProseOf(string path) => LongProse(File.ReadLines(path)).Select(number => PlaceOf(path, number));

    private static string PlaceOf(string path, int line) => $"{Path.GetRelativePath(Repository.Root, path)}, line {line}";

    private static IEnumerable<int> LongProse(IEnumerable<string> lines)
    {
        bool isInCode = false;
        int number = 0;
        foreach (string line in lines)
        {
            number++;
            if (line.TrimStart().StartsWith("```", StringComparison.Ordinal))
            {
                isInCode = !isInCode;
            }
            else if (!isInCode && line.Length > MaxColumns && !line.TrimStart().StartsWith('|'))
            {
                yield return number;
            }
        }
    }

    // The content of a raw string is data: what the tests read as a file has the lines of that file.
    private static IEnumerable<int> LongLines(IEnumerable<string> lines)
    {
        bool isInRawString = false;
        int number = 0;
        foreach (string line in lines)
        {
            number++;
            if (!isInRawString && line.Length > MaxColumns)
            {
                yield return number;
            }

            isInRawString ^= line.Split("\"\"\"").Length % 2 == 0;
        }
    }
}
