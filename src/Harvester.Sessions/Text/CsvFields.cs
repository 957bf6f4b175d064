using System.Text;

namespace Harvester.Sessions.Text;

/// <summary>One line of comma-separated values, RFC 4180 without line breaks within fields.</summary>
internal static class CsvFields
{
    /// <summary>The message for a line that cannot be split.</summary>
    public const string Problem = "a quoted field is not closed, or a quotation mark stands in an unquoted field.";

    /// <summary>The fields of a line, or null if its quotation marks are misplaced.</summary>
    public static List<string>? Split(string line)
    {
        if (line.IndexOf('"') < 0)
        {
            return [.. line.Split(',')];
        }

        var fields = new List<string>();
        var field = new StringBuilder();
        bool quoted = false;
        bool closed = false;
        for (int i = 0; i < line.Length; i++)
        {
            char letter = line[i];
            if (quoted && letter == '"' && i + 1 < line.Length && line[i + 1] == '"')
            {
                field.Append('"');
                i++;
            }
            else if (quoted && letter == '"')
            {
                quoted = false;
                closed = true;
            }
            else if (letter == ',' && !quoted)
            {
                fields.Add(field.ToString());
                field.Clear();
                closed = false;
            }
            else if (closed || (letter == '"' && field.Length > 0 && !quoted))
            {
                return null;
            }
            else if (letter == '"')
            {
                quoted = true;
            }
            else
            {
                field.Append(letter);
            }
        }

        fields.Add(field.ToString());
        return quoted ? null : fields;
    }

    /// <summary>A field as written in a line: in quotation marks if it needs them.</summary>
    public static string Quote(string field) => field.IndexOfAny([',', '"']) < 0 ? field : "\"" + field.Replace("\"", "\"\"") + "\"";
}
