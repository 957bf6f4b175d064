using System.Text.RegularExpressions;

namespace Harvester.Architecture.Tests;

/// <summary>The methods that docs/architecture.md lists for a frame and for a step of a client are in the files that it names.</summary>
public sealed partial class FlowTableTests
{
    public static TheoryData<string> Flows => ["## One frame, method by method", "## One step of a client, method by method"];

    [Theory]
    [MemberData(nameof(Flows))]
    public void Listed_methods_are_in_the_files_named(string heading)
    {
        (string Type, string Method, string File)[] rows = [.. RowsOf(heading)];

        Assert.NotEmpty(rows);
        Assert.All(rows, row => Assert.True(IsThere(row.Type, row.Method, row.File), $"{row.Type}.{row.Method} is not in {row.File}."));
    }

    [Theory]
    [MemberData(nameof(Flows))]
    public void Methods_are_listed_once_and_counted(string heading)
    {
        string[] section = [.. SectionOf(heading)];
        int[] numbers =
        [
            .. section.Select(line => Row().Match(line)).Where(row => row.Success).Select(row => int.Parse(row.Groups[1].Value)),
        ];

        Assert.Equal(Enumerable.Range(1, numbers.Length), numbers);
        Assert.Equal(numbers.Length, RowsOf(heading).Select(row => (row.Type, row.Method)).Distinct().Count());
        Assert.Contains(section, line => line.Contains($"{numbers.Length} methods", StringComparison.Ordinal));
    }

    private static bool IsThere(string type, string method, string file)
    {
        string path = Path.Combine(Repository.Root, "src", file);
        return File.Exists(path)
            && Path.GetFileNameWithoutExtension(path) == type
            && Regex.IsMatch(File.ReadAllText(path), $@"\b{method}\(");
    }

    private static IEnumerable<(string Type, string Method, string File)> RowsOf(string heading) =>
        SectionOf(heading)
            .Select(line => Row().Match(line))
            .Where(row => row.Success)
            .Select(row => (row.Groups[2].Value, row.Groups[3].Value, row.Groups[4].Value + "/" + row.Groups[2].Value + ".cs"));

    private static IEnumerable<string> SectionOf(string heading) =>
        File.ReadLines(Path.Combine(Repository.Root, "docs", "architecture.md"))
            .SkipWhile(line => line != heading)
            .Skip(1)
            .TakeWhile(line => !line.StartsWith("## ", StringComparison.Ordinal));

    [GeneratedRegex(@"^\| (\d+) \| `(\w+)\.(\w+)` \| `([\w./]+)` \|")]
    private static partial Regex Row();
}
