using System.Globalization;
using System.Net;

namespace Harvester.Sessions.Text;

/// <summary>
/// A settings file: lines of <c>Name = value</c> under <c>[Section]</c>. Lines that begin with ; or # are comments, as is the text after a
/// blank and a semicolon. Names are not case-sensitive. Numbers are in the invariant culture. For an unreadable value the default is used,
/// and <see cref="Complaints"/> names its line; nothing is thrown.
/// </summary>
public sealed class IniFile
{
    private readonly Dictionary<string, (int Line, string Text)> _values = new(StringComparer.OrdinalIgnoreCase);
    private readonly HashSet<string> _asked = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<(int Line, string Text)> _complaints = [];
    private readonly Dictionary<int, string> _changes = [];

    private IniFile() { }

    /// <summary>The problems found so far, in the order of the lines: one sentence each.</summary>
    public IReadOnlyList<string> Complaints =>
        _complaints
            .Concat(
                _values
                    .Where(value => !_asked.Contains(value.Key))
                    .Select(value => (value.Value.Line, Text: $"there is no setting {NameOf(value.Key)}."))
            )
            .OrderBy(complaint => complaint.Line)
            .Select(complaint => string.Format(CultureInfo.InvariantCulture, "Line {0}: {1}", complaint.Line, complaint.Text))
            .ToArray();

    /// <summary>The settings read so far that differ from their defaults, in the order of their lines: "[Section] Name = value".</summary>
    public IReadOnlyList<string> Changes => [.. _changes.OrderBy(change => change.Key).Select(change => change.Value)];

    /// <summary>Reads a file to its end.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static IniFile Read(TextReader reader)
    {
        if (reader is null)
        {
            throw new ArgumentNullException(nameof(reader));
        }

        var file = new IniFile();
        string section = string.Empty;
        int number = 0;
        while (reader.ReadLine() is { } line)
        {
            number++;
            string content = WithoutComment(line).Trim();
            if (content.Length == 0)
            {
                continue;
            }

            if (content[0] == '[' && content[content.Length - 1] == ']')
            {
                section = content.Substring(1, content.Length - 2).Trim();
                continue;
            }

            file.Add(section, content, number);
        }

        return file;
    }

    /// <summary>A text.</summary>
    public string Text(string section, string name, string fallback) =>
        Parse(section, name, fallback, string.Empty, static text => (true, text));

    /// <summary>A number within a range.</summary>
    public double Number(string section, string name, double fallback, double minimum, double maximum) =>
        Parse(
            section,
            name,
            fallback,
            FormattableString.Invariant($"a number from {minimum} to {maximum}"),
            text =>
                double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                && value >= minimum
                && value <= maximum
                    ? (true, value)
                    : (false, fallback)
        );

    /// <summary>A whole number within a range.</summary>
    public int Whole(string section, string name, int fallback, int minimum, int maximum) =>
        Parse(
            section,
            name,
            fallback,
            FormattableString.Invariant($"a whole number from {minimum} to {maximum}"),
            text =>
                int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
                && value >= minimum
                && value <= maximum
                    ? (true, value)
                    : (false, fallback)
        );

    /// <summary>An IP address.</summary>
    public IPAddress Address(string section, string name, IPAddress fallback) =>
        Parse(
            section,
            name,
            fallback,
            "an address such as 127.0.0.1",
            text => IPAddress.TryParse(text, out IPAddress? address) ? (true, address) : (false, fallback)
        );

    /// <summary>A member of an enumeration; the name is not case-sensitive.</summary>
    /// <typeparam name="T">The enumeration.</typeparam>
    public T Choice<T>(string section, string name, T fallback, string expected)
        where T : struct, Enum =>
        Parse(section, name, fallback, expected, text => TryName(text, out T value) ? (true, value) : (false, fallback));

    /// <summary>Members of an enumeration, separated by commas.</summary>
    /// <typeparam name="T">The enumeration.</typeparam>
    public IReadOnlyList<T> Choices<T>(string section, string name, IReadOnlyList<T> fallback, string expected)
        where T : struct, Enum =>
        Parse(
            section,
            name,
            fallback,
            expected,
            text =>
            {
                var chosen = new List<T>();
                bool good = text.Split(',')
                    .All(part =>
                    {
                        bool known = TryName(part.Trim(), out T value);
                        chosen.Add(value);
                        return known;
                    });
                return (good, good && chosen.SequenceEqual(fallback) ? fallback : chosen);
            }
        );

    /// <summary>Different values separated by commas; none by default.</summary>
    /// <typeparam name="T">Their type.</typeparam>
    /// <param name="section">The section.</param>
    /// <param name="name">The name.</param>
    /// <param name="expected">What the list must be.</param>
    /// <param name="parse">Reads a value; null if the text is not one.</param>
    public IReadOnlyList<T> List<T>(string section, string name, string expected, Func<string, T?> parse)
        where T : class =>
        Parse<IReadOnlyList<T>>(
            section,
            name,
            [],
            expected,
            text =>
            {
                string[] parts = [.. text.Split(',').Select(part => part.Trim())];
                T[] values = [.. parts.Select(parse).OfType<T>()];
                return (values.Length == parts.Length && parts.Distinct().Count() == parts.Length, values);
            }
        );

    private static bool TryName<T>(string text, out T value)
        where T : struct, Enum
    {
        // Enum.TryParse alone would also accept numbers and lists.
        value = default;
        return text.Length > 0
            && text.All(char.IsLetterOrDigit)
            && char.IsLetter(text[0])
            && Enum.TryParse(text, ignoreCase: true, out value);
    }

    private static string WithoutComment(string line)
    {
        string trimmed = line.TrimStart(' ', '\t', '\uFEFF');
        if (trimmed.Length > 0 && (trimmed[0] == ';' || trimmed[0] == '#'))
        {
            return string.Empty;
        }

        int comment = line.IndexOf(" ;", StringComparison.Ordinal);
        return (comment < 0 ? line : line.Substring(0, comment)).TrimStart('\uFEFF');
    }

    private static string KeyOf(string section, string name) => section + "]" + name;

    private static string NameOf(string key) => "[" + key.Replace("]", "] ");

    private void Add(string section, string content, int line)
    {
        int equals = content.IndexOf('=');
        if (equals < 1)
        {
            _complaints.Add((line, $"'{content}' is not of the form Name = value."));
            return;
        }

        string key = KeyOf(section, content.Substring(0, equals).Trim());
        if (_values.TryGetValue(key, out (int Line, string Text) first))
        {
            _complaints.Add((line, FormattableString.Invariant($"{NameOf(key)} is already set in line {first.Line}; that value is used.")));
            return;
        }

        _values.Add(key, (line, content.Substring(equals + 1).Trim()));
    }

    private (int Line, string Text)? Find(string section, string name)
    {
        string key = KeyOf(section, name);
        _asked.Add(key);
        return _values.TryGetValue(key, out (int Line, string Text) value) && value.Text.Length > 0 ? value : null;
    }

    private T Parse<T>(string section, string name, T fallback, string expected, Func<string, (bool Good, T Value)> parse)
    {
        if (Find(section, name) is not { } found)
        {
            return fallback;
        }

        (bool good, T value) = parse(found.Text);
        if (!good)
        {
            _complaints.Add((found.Line, $"{name} = {found.Text} is not {expected}; the default is used."));
        }
        else if (!EqualityComparer<T>.Default.Equals(value, fallback))
        {
            _changes[found.Line] = $"[{section}] {name} = {found.Text}";
        }

        return good ? value : fallback;
    }
}
