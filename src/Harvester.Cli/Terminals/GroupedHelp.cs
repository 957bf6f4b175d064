using System.Text;

namespace Harvester.Cli.Terminals;

/// <summary>Divides the list of options in a help text into groups with headings.</summary>
internal static class GroupedHelp
{
    /// <summary>The heading of the options of every command.</summary>
    public const string General = "General";

    private const string List = "Options:\n";

    /// <summary>The help with its options in groups; those in no group come last, under <see cref="General"/>.</summary>
    /// <param name="help">The help text with one list of options.</param>
    /// <param name="groups">The groups.</param>
    public static string Of(string help, IReadOnlyList<OptionGroup> groups)
    {
        string text = help.ReplaceLineEndings("\n");
        int start = text.IndexOf(List, StringComparison.Ordinal);
        int end = text.IndexOf("\n\n", start, StringComparison.Ordinal);
        (string Name, string Lines)[] entries = [.. EntriesOf(text[(start + List.Length)..(end < 0 ? text.Length : end)])];
        Dictionary<string, string> known = entries.ToDictionary(entry => entry.Name, entry => entry.Lines);
        HashSet<string> grouped = [.. groups.SelectMany(group => group.Options)];
        OptionGroup others = new(General, [.. entries.Select(entry => entry.Name).Where(name => !grouped.Contains(name))]);
        string lists = string.Join(
            '\n',
            groups.Append(others).Select(group => $"{group.Heading}:\n{string.Concat(group.Options.Select(name => known[name]))}")
        );
        return text[..start] + lists + (end < 0 ? "" : text[(end + 1)..]);
    }

    /// <summary>The entries of a list with the names they begin with; a wrapped description continues in further lines.</summary>
    private static IEnumerable<(string Name, string Lines)> EntriesOf(string list)
    {
        var lines = new StringBuilder();
        string name = "";
        foreach (string line in list.Split('\n', StringSplitOptions.RemoveEmptyEntries))
        {
            if (line.StartsWith("  -", StringComparison.Ordinal))
            {
                if (lines.Length > 0)
                {
                    yield return (name, lines.ToString());
                }

                name = line.Split([' ', ','], StringSplitOptions.RemoveEmptyEntries)[0];
                lines.Clear();
            }

            lines.Append(line).Append('\n');
        }

        yield return (name, lines.ToString());
    }
}
