using System.Text.RegularExpressions;

namespace Harvester.Exports.Tests.Columns;

/// <summary>A table as docs/exports/parquet.md describes it.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Columns">The columns with their type, unit and field, in order.</param>
internal sealed partial record DocumentedTable(string Name, IReadOnlyList<(string Name, string Type, string Unit, string Field)> Columns)
{
    /// <summary>The page.</summary>
    public static string Page { get; } = File.ReadAllText(Path.Combine(Root, "docs/exports/parquet.md"));

    /// <summary>Folder of the repository.</summary>
    public static string Root
    {
        get
        {
            string folder = AppContext.BaseDirectory;
            while (!File.Exists(Path.Combine(folder, "GtaDataHarvester.sln")))
            {
                folder = Path.GetDirectoryName(folder)!;
            }

            return folder;
        }
    }

    /// <summary>The tables of the page, in its order.</summary>
    public static IReadOnlyList<DocumentedTable> All { get; } =
    [.. Sections().Matches(Page).Select(section => new DocumentedTable(section.Groups["name"].Value, ColumnsIn(section.Value)))];

    /// <summary>The queries of the page.</summary>
    public static IReadOnlyList<string> Queries { get; } = [.. Blocks().Matches(Page).Select(block => block.Groups["sql"].Value)];

    private static List<(string, string, string, string)> ColumnsIn(string section) =>
        [
            .. Rows()
                .Matches(section)
                .SelectMany(row =>
                {
                    string[] names = [.. row.Groups["names"].Value.Split(", ").Select(name => name.Trim('`'))];
                    string field = row.Groups["field"].Value.Trim('`');
                    return names.Select(
                        (name, i) => (name, row.Groups["type"].Value, row.Groups["unit"].Value, names.Length == 1 ? field : $"{field}[{i}]")
                    );
                }),
        ];

    [GeneratedRegex(@"^### `(?<name>\w+)`\n(?:(?!^#).*\n)*", RegexOptions.Multiline)]
    private static partial Regex Sections();

    [GeneratedRegex(@"^\| (?<names>`[^|]*`) \| (?<type>[^|]*?) \| (?<unit>[^|]*?) ?\| (?<field>[^|]*?) ?\|$", RegexOptions.Multiline)]
    private static partial Regex Rows();

    [GeneratedRegex("^```sql\n(?<sql>[^`]*)```$", RegexOptions.Multiline)]
    private static partial Regex Blocks();
}
