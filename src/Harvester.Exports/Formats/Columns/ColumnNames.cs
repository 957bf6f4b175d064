using System.Text;

namespace Harvester.Exports.Formats.Columns;

/// <summary>Names of columns: those of the label's fields, in lower case with underscores.</summary>
internal static class ColumnNames
{
    /// <summary>The name of the column of a field: "lane_width_metres" for "laneWidthMetres".</summary>
    public static string Of(string field)
    {
        var name = new StringBuilder();
        for (int i = 0; i < field.Length; i++)
        {
            // A row of capitals, as in toMarkingLL, stays one word.
            if (char.IsAsciiLetterUpper(field[i]) && i > 0 && !char.IsAsciiLetterUpper(field[i - 1]))
            {
                name.Append('_');
            }

            name.Append(char.ToLowerInvariant(field[i]));
        }

        return name.ToString();
    }
}
