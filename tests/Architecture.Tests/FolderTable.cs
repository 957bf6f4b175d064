using System.Text.RegularExpressions;

namespace Harvester.Architecture.Tests;

/// <summary>The table of folders in docs/architecture.md: for each project its folders; each may use only those before it.</summary>
internal static partial class FolderTable
{
    /// <summary>The folders of a project in their order; empty if the table does not have it.</summary>
    public static IReadOnlyList<string> Of(string project) =>
        Read(File.ReadLines(Page)).TryGetValue(project, out List<string>? found) ? found : [];

    /// <summary>The projects that have a section.</summary>
    public static IReadOnlyCollection<string> Projects => Read(File.ReadLines(Page)).Keys;

    private static string Page => Path.Combine(Repository.Root, "docs", "architecture.md");

    /// <summary>Reads the rows: one with the name of a project in bold begins its section, the others name its folders.</summary>
    internal static Dictionary<string, List<string>> Read(IEnumerable<string> page)
    {
        var folders = new Dictionary<string, List<string>>(StringComparer.Ordinal);
        List<string>? current = null;
        foreach (
            string line in page.SkipWhile(line => line != "## Folders")
                .Skip(1)
                .TakeWhile(line => !line.StartsWith("## ", StringComparison.Ordinal))
        )
        {
            string cell = line.StartsWith('|') ? line.Split('|')[1] : string.Empty;
            if (Section().Match(cell) is { Success: true } section)
            {
                folders.Add("Harvester." + section.Groups[1].Value, current = []);
            }

            current?.AddRange(Folder().Matches(cell).Select(folder => folder.Groups[1].Value));
        }

        return folders;
    }

    [GeneratedRegex(@"\*\*(\w+)\*\*")]
    private static partial Regex Section();

    [GeneratedRegex(@"`(\w+)`")]
    private static partial Regex Folder();
}
