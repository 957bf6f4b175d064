using System.Text.Json;

namespace Harvester.Exports.Formats.Columns;

/// <summary>A field of a label that becomes one column, or several if it is a vector; or a column of the frame's own.</summary>
internal sealed class TableField
{
    private readonly Action<RowEncoder, TableRow> _write;

    private TableField(Action<RowEncoder, TableRow> write, params TableColumn[] columns)
    {
        _write = write;
        Columns = columns;
    }

    /// <summary>Its columns.</summary>
    public IReadOnlyList<TableColumn> Columns { get; }

    /// <summary>A whole number that every row has.</summary>
    /// <param name="name">Name of the column.</param>
    /// <param name="value">Its value.</param>
    /// <param name="field">The field of the label that it is.</param>
    public static TableField Key(string name, Func<TableRow, int> value, string field = "") =>
        new((encoder, row) => encoder.Integer(value(row)), new TableColumn(name, ColumnKind.Integer, "", field) { IsRequired = true });

    /// <summary>A text that every row has and the label has not, or has otherwise.</summary>
    /// <param name="name">Name of the column.</param>
    /// <param name="value">Its value.</param>
    /// <param name="kind">Its type.</param>
    /// <param name="field">The field of the label from which it follows.</param>
    public static TableField Given(string name, Func<TableRow, string> value, ColumnKind kind = ColumnKind.Word, string field = "") =>
        new((encoder, row) => encoder.Text(value(row)), new TableColumn(name, kind, "", field) { IsRequired = true });

    /// <summary>A field that is one value or a list.</summary>
    /// <param name="name">Name of the column.</param>
    /// <param name="kind">Its type.</param>
    /// <param name="path">Path in the part, with dots; empty for the part itself.</param>
    /// <param name="unit">Unit and frame.</param>
    /// <param name="part">Number of the part of the row.</param>
    /// <param name="field">Its path from the field that the row is; null if that is the path.</param>
    public static TableField Of(string name, ColumnKind kind, string path, string unit = "", int part = 0, string? field = null)
    {
        string[] steps = Steps(path);
        var column = new TableColumn(name, kind, unit, field ?? path);
        return new((encoder, row) => encoder.Value(kind, At(row, part, steps), name), column);
    }

    /// <summary>A field that is a list of numbers, each with a column.</summary>
    /// <param name="names">Names of the columns.</param>
    /// <param name="path">Path in the part.</param>
    /// <param name="unit">Unit and frame.</param>
    /// <param name="part">Number of the part of the row.</param>
    /// <param name="field">Its path from the field that the row is; null if that is the path.</param>
    public static TableField Vector(IReadOnlyList<string> names, string path, string unit, int part = 0, string? field = null)
    {
        string[] steps = Steps(path);
        return new(
            (encoder, row) =>
            {
                JsonElement list = At(row, part, steps);
                int length = list.ValueKind == JsonValueKind.Array ? list.GetArrayLength() : 0;
                for (int i = 0; i < names.Count; i++)
                {
                    encoder.Value(ColumnKind.Number, i < length ? list[i] : default, names[i]);
                }
            },
            [.. names.Select((name, i) => new TableColumn(name, ColumnKind.Number, unit, $"{field ?? path}[{Numbers.Text(i)}]"))]
        );
    }

    /// <summary>A field that is a vector along three axes, x, y and z of the world unless named otherwise.</summary>
    public static TableField Axes(string name, string path, string unit, params string[] axes) =>
        Vector([.. (axes.Length == 0 ? ["x", "y", "z"] : axes).Select(axis => $"{name}_{axis}")], path, unit);

    /// <summary>A field that is a box.</summary>
    public static TableField Box(string name, string path) =>
        Vector([.. ((string[])["xmin", "ymin", "xmax", "ymax"]).Select(side => $"{name}_{side}")], path, "px, image");

    /// <summary>Fields of an object with a column each.</summary>
    /// <param name="prefix">Begin of the columns' names.</param>
    /// <param name="kind">Type of all of them.</param>
    /// <param name="path">Path of the object.</param>
    /// <param name="unit">Unit and frame.</param>
    /// <param name="fields">Names of the fields.</param>
    public static IEnumerable<TableField> Fields(string prefix, ColumnKind kind, string path, string unit, params string[] fields) =>
        fields.Select(field => Of(prefix + ColumnNames.Of(field), kind, path.Length == 0 ? field : $"{path}.{field}", unit));

    /// <summary>Writes the values of a row.</summary>
    public void Write(RowEncoder encoder, TableRow row) => _write(encoder, row);

    private static string[] Steps(string path) => path.Length == 0 ? [] : path.Split('.');

    private static JsonElement At(TableRow row, int part, string[] steps)
    {
        JsonElement element = row.Parts[part];
        foreach (string step in steps)
        {
            if (element.ValueKind != JsonValueKind.Object || !element.TryGetProperty(step, out element))
            {
                return default;
            }
        }

        return element;
    }
}
