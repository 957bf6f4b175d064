using System.Text.Json;

namespace Harvester.Exports.Formats.Columns;

/// <summary>A table of labels: its columns, and how the rows of a frame follow from the label line.</summary>
/// <param name="name">Name of the file, without extension.</param>
/// <param name="meaning">What a row is.</param>
/// <param name="fields">The fields, in the order of the columns.</param>
/// <param name="rows">The rows of a frame.</param>
internal sealed class LabelTable(
    string name,
    string meaning,
    IReadOnlyList<TableField> fields,
    Func<TableFrame, JsonElement, IEnumerable<TableRow>> rows
)
{
    /// <summary>Name of the table, and of its part in the journal.</summary>
    public string Name => name;

    /// <summary>What a row is.</summary>
    public string Meaning => meaning;

    /// <summary>Name of the file.</summary>
    public string FileName => $"{name}.parquet";

    /// <summary>The columns.</summary>
    public IReadOnlyList<TableColumn> Columns { get; } = [.. fields.SelectMany(field => field.Columns)];

    /// <summary>The rows of a frame as bytes.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="label">Its label line.</param>
    public RowEncoder Encode(TableFrame frame, JsonElement label)
    {
        var encoder = new RowEncoder();
        foreach (TableRow row in rows(frame, label))
        {
            foreach (TableField field in fields)
            {
                field.Write(encoder, row);
            }
        }

        return encoder;
    }

    /// <summary>The items of a list of the label; none if it is missing or null.</summary>
    public static IEnumerable<JsonElement> List(JsonElement element, params string[] path)
    {
        JsonElement list = At(element, path);
        return list.ValueKind == JsonValueKind.Array ? list.EnumerateArray() : Enumerable.Empty<JsonElement>();
    }

    /// <summary>A field of a field; undefined if it is missing.</summary>
    public static JsonElement At(JsonElement element, params string[] path)
    {
        foreach (string step in path)
        {
            if (element.ValueKind != JsonValueKind.Object || !element.TryGetProperty(step, out element))
            {
                return default;
            }
        }

        return element;
    }
}
