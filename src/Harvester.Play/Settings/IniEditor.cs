using System.Globalization;
using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Play.Settings;

/// <summary>
/// Changes values in a settings file that the player edits too: everything else in it stays unchanged, including comments.
/// </summary>
public static class IniEditor
{
    /// <summary>Sets numbers of a section; missing ones are added. The file is replaced completely or not at all.</summary>
    /// <param name="path">The file; created if it does not exist.</param>
    /// <param name="section">Name of the section.</param>
    /// <param name="values">Names and numbers.</param>
    /// <exception cref="IOException">The file cannot be read or written.</exception>
    public static void Set(string path, string section, IReadOnlyList<KeyValuePair<string, double>> values) =>
        Set(
            path,
            section,
            [
                .. values.Select(value => new KeyValuePair<string, string>(
                    value.Key,
                    string.Format(CultureInfo.InvariantCulture, "{0:0.########}", value.Value == 0 ? 0 : value.Value)
                )),
            ]
        );

    /// <summary>Sets one value of a section, which is added if it is missing. The file is replaced completely or not at all.</summary>
    /// <param name="path">The file; created if it does not exist.</param>
    /// <param name="section">Name of the section.</param>
    /// <param name="name">Name of the value.</param>
    /// <param name="value">The value, on one line.</param>
    /// <exception cref="IOException">The file cannot be read or written.</exception>
    public static void Set(string path, string section, string name, string value) =>
        Set(path, section, [new KeyValuePair<string, string>(name, value)]);

    private static void Set(string path, string section, IReadOnlyList<KeyValuePair<string, string>> values)
    {
        string[] before = File.Exists(path) ? File.ReadAllLines(path, Encoding.UTF8) : [];
        AtomicFile.Write(path, string.Concat(Changed(before, section, values).Select(line => line + Environment.NewLine)));
    }

    private static List<string> Changed(string[] before, string section, IReadOnlyList<KeyValuePair<string, string>> values)
    {
        var lines = before.ToList();
        int header = lines.FindIndex(line => IsName(line.Trim(), $"[{section}]"));
        if (header < 0)
        {
            lines.Add($"[{section}]");
            header = lines.Count - 1;
        }

        // In reverse, so that added values are in the given order.
        foreach (KeyValuePair<string, string> value in values.Reverse())
        {
            string line = $"{value.Key} = {value.Value}";
            int next = lines.FindIndex(header + 1, text => text.TrimStart().StartsWith("[", StringComparison.Ordinal));
            int end = next < 0 ? lines.Count : next;
            int place = lines.FindIndex(
                header + 1,
                end - header - 1,
                text => IsName(text.Split('=')[0].Trim(), value.Key) && text.Contains("=")
            );
            if (place < 0)
            {
                lines.Insert(header + 1, line);
            }
            else
            {
                lines[place] = line;
            }
        }

        return lines;
    }

    private static bool IsName(string text, string name) => string.Equals(text, name, StringComparison.OrdinalIgnoreCase);
}
