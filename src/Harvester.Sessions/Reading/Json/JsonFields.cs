using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Reading.Json;

/// <summary>
/// An object of a JSON text whose fields are read by name. Every error names the field by its path, such as camera.position.
/// </summary>
public readonly struct JsonFields : IJsonFields
{
    /// <summary>
    /// Limit of numbers. No length, time or angle of a session is as large, and sums and products of smaller numbers stay finite.
    /// </summary>
    private const double MaxMagnitude = 1e12;

    /// <summary>Limit of strings. They are names that stay in memory, one per object of a session.</summary>
    private const int MaxTextCharacters = 4096;

    private readonly JsonElement _element;
    private readonly string _path;

    /// <summary>Takes the outermost object of a text.</summary>
    /// <exception cref="DatasetFormatException">It is not an object.</exception>
    public JsonFields(JsonElement element)
        : this(element, "") { }

    private JsonFields(JsonElement element, string path)
    {
        _element = element;
        _path = path;
        if (element.ValueKind != JsonValueKind.Object)
        {
            throw Wrong(path.Length == 0 ? "the text" : path, "an object", element);
        }
    }

    /// <summary>Whether a field exists and is not null.</summary>
    public bool Has(string name) => _element.TryGetProperty(name, out JsonElement field) && field.ValueKind != JsonValueKind.Null;

    /// <summary>The names of all fields, in their order.</summary>
    public IEnumerable<string> Names => _element.EnumerateObject().Select(static member => member.Name);

    /// <summary>A number from -1e12 to 1e12.</summary>
    public double Number(string name)
    {
        JsonElement field = Field(name);
        return IsFinite(field, out double value) ? value : throw Wrong(Path(name), "a finite number, 1e12 at most", field);
    }

    /// <summary>A finite number; null if the field is absent or null.</summary>
    public double? OptionalNumber(string name) => Has(name) ? Number(name) : null;

    /// <summary>A 64-bit integer.</summary>
    public long LongInteger(string name)
    {
        JsonElement field = Field(name);
        return field.ValueKind == JsonValueKind.Number && field.TryGetInt64(out long value)
            ? value
            : throw Wrong(Path(name), "a whole number", field);
    }

    /// <summary>A 32-bit integer.</summary>
    public int Integer(string name)
    {
        long value = LongInteger(name);
        return value is >= int.MinValue and <= int.MaxValue ? (int)value : throw Wrong(Path(name), "a 32-bit whole number", Field(name));
    }

    /// <summary>A string.</summary>
    public string Text(string name)
    {
        JsonElement field = Field(name);
        string text = field.ValueKind == JsonValueKind.String ? field.GetString()! : throw Wrong(Path(name), "a text", field);
        return text.Length <= MaxTextCharacters
            ? text
            : throw new DatasetFormatException($"{Path(name)} has {text.Length} characters; {MaxTextCharacters} is the limit.");
    }

    /// <summary>A string; null if the field is absent or null.</summary>
    public string? OptionalText(string name) => Has(name) ? Text(name) : null;

    /// <summary>A value of an enumeration; its name begins with a small letter.</summary>
    public T Name<T>(string name)
        where T : struct, Enum
    {
        string text = Text(name);
        return JsonNames.TryRead(text, out T value)
            ? value
            : throw Wrong(Path(name), "one of " + string.Join(", ", JsonNames.All<T>()), Field(name));
    }

    /// <summary>A list of finite numbers, of a given length.</summary>
    public double[] Numbers(string name, int count)
    {
        double[] numbers = new double[count];
        Fill(name, numbers);
        return numbers;
    }

    /// <summary>A list of finite numbers.</summary>
    public double[] Numbers(string name) => NumbersOf(Field(name), name);

    /// <summary>A list of lists of finite numbers, each of its own length.</summary>
    public double[][] Rows(string name) => RowsOf(name, null);

    /// <summary>Whether a field is a list.</summary>
    public bool IsList(string name) => Field(name).ValueKind == JsonValueKind.Array;

    /// <summary>A boolean.</summary>
    public bool Boolean(string name) => BooleanOf(Field(name), name);

    /// <summary>A boolean; null if the field is absent or null.</summary>
    public bool? OptionalBoolean(string name) => Has(name) ? Boolean(name) : null;

    /// <summary>A list of true, false and null.</summary>
    public bool?[] OptionalBooleans(string name)
    {
        JsonElement list = Field(name);
        if (list.ValueKind != JsonValueKind.Array)
        {
            throw Wrong(Path(name), "a list of true, false and null", list);
        }

        var truths = new List<bool?>(list.GetArrayLength());
        foreach (JsonElement item in list.EnumerateArray())
        {
            truths.Add(item.ValueKind == JsonValueKind.Null ? null : BooleanOf(item, name, truths.Count));
        }

        return [.. truths];
    }

    /// <summary>A list of lists of finite numbers, each of a given length.</summary>
    public double[][] Rows(string name, int count) => RowsOf(name, count);

    /// <summary>A list of three numbers as a vector.</summary>
    public Vector3D Vector(string name)
    {
        Span<double> numbers = stackalloc double[3];
        Fill(name, numbers);
        return new Vector3D(numbers[0], numbers[1], numbers[2]);
    }

    /// <summary>A list of lists of three numbers as vectors.</summary>
    public Vector3D[] Vectors(string name)
    {
        Span<double> numbers = stackalloc double[3];
        JsonElement list = ListOfLists(name, numbers.Length);
        var vectors = new Vector3D[list.GetArrayLength()];
        int count = 0;
        foreach (JsonElement row in list.EnumerateArray())
        {
            FillRow(row, name, count, numbers);
            vectors[count++] = new Vector3D(numbers[0], numbers[1], numbers[2]);
        }

        return vectors;
    }

    /// <summary>A list of lists of two numbers as points of an image.</summary>
    public Vector2D[] Points(string name)
    {
        Span<double> numbers = stackalloc double[2];
        JsonElement list = ListOfLists(name, numbers.Length);
        var points = new Vector2D[list.GetArrayLength()];
        int count = 0;
        foreach (JsonElement row in list.EnumerateArray())
        {
            FillRow(row, name, count, numbers);
            points[count++] = new Vector2D(numbers[0], numbers[1]);
        }

        return points;
    }

    /// <summary>The fields right, forward and up as an orientation.</summary>
    public Axes Axes()
    {
        Vector3D right = Vector("right");
        Vector3D forward = Vector("forward");
        Vector3D up = Vector("up");
        return Checked(() => Harvester.Geometry.Axes.FromVectors(right, forward, up));
    }

    /// <summary>A list of strings.</summary>
    public string[] Texts(string name)
    {
        JsonElement list = Field(name);
        return list.ValueKind == JsonValueKind.Array && list.EnumerateArray().All(item => item.ValueKind == JsonValueKind.String)
            ? [.. list.EnumerateArray().Select(item => item.GetString()!)]
            : throw Wrong(Path(name), "a list of strings", list);
    }

    /// <summary>The JSON of a field, exactly as in the text.</summary>
    public string RawText(string name) => Field(name).GetRawText();

    /// <summary>A nested object.</summary>
    public JsonFields Fields(string name) => new(Field(name), Path(name));

    /// <summary>A list of objects.</summary>
    public IReadOnlyList<JsonFields> List(string name)
    {
        JsonElement field = Field(name);
        string path = Path(name);
        return field.ValueKind == JsonValueKind.Array
            ? [.. field.EnumerateArray().Select((item, index) => new JsonFields(item, $"{path}[{index}]"))]
            : throw Wrong(path, "a list of objects", field);
    }

    IJsonFields IJsonFields.Fields(string name) => Fields(name);

    IReadOnlyList<IJsonFields> IJsonFields.List(string name) => [.. List(name).Select(static fields => (IJsonFields)fields)];

    Exception IJsonFields.Refusal(string message) => new DatasetFormatException(message);

    /// <summary>Creates a value from this object's fields; if it is invalid, the error names this object.</summary>
    public T Checked<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (ArgumentException e)
        {
            // Only the first part of the message is for the user; the parameter and its value follow it.
            string message = e.Message.Split(" (Parameter '")[0];
            throw new DatasetFormatException(_path.Length == 0 ? message : $"{_path}: {message}", e);
        }
    }

    /// <summary>Rejects fields of other names, so that misspelt names are not ignored.</summary>
    /// <exception cref="DatasetFormatException">There is another field.</exception>
    public void AllowOnly(params IReadOnlyList<string> names)
    {
        string? other = _element
            .EnumerateObject()
            .Select(property => property.Name)
            .FirstOrDefault(name => !names.Contains(name, StringComparer.Ordinal));
        if (other is not null)
        {
            throw new DatasetFormatException($"{Path(other)} is an unknown field. Known fields: {string.Join(", ", names)}.");
        }
    }

    private double[][] RowsOf(string name, int? count)
    {
        JsonElement list = ListOfLists(name, count);
        var rows = new List<double[]>(list.GetArrayLength());
        foreach (JsonElement row in list.EnumerateArray())
        {
            if (count is null && row.ValueKind != JsonValueKind.Array)
            {
                throw Wrong(Place(name, rows.Count), "a list of numbers", row);
            }

            double[] numbers = new double[count ?? row.GetArrayLength()];
            FillRow(row, name, rows.Count, numbers);
            rows.Add(numbers);
        }

        return [.. rows];
    }

    private JsonElement ListOfLists(string name, int? count)
    {
        JsonElement list = Field(name);
        return list.ValueKind == JsonValueKind.Array
            ? list
            : throw Wrong(Path(name), count is null ? "a list of lists of numbers" : $"a list of lists of {count} numbers", list);
    }

    private double[] NumbersOf(JsonElement list, string name)
    {
        if (list.ValueKind != JsonValueKind.Array)
        {
            throw Wrong(Path(name), "a list of numbers", list);
        }

        var numbers = new double[list.GetArrayLength()];
        Fill(list, name, numbers);
        return numbers;
    }

    /// <summary>Fills all of a span with the numbers of a field.</summary>
    private void Fill(string name, Span<double> numbers)
    {
        JsonElement field = Field(name);
        if (field.ValueKind != JsonValueKind.Array || field.GetArrayLength() != numbers.Length)
        {
            throw Wrong(Path(name), $"a list of {numbers.Length} numbers", field);
        }

        Fill(field, name, numbers);
    }

    /// <summary>Fills all of a span with the numbers of a row of a field.</summary>
    private void FillRow(JsonElement row, string name, int place, Span<double> numbers)
    {
        if (row.ValueKind != JsonValueKind.Array || row.GetArrayLength() != numbers.Length)
        {
            throw Wrong(Place(name, place), $"a list of {numbers.Length} numbers", row);
        }

        Fill(row, name, numbers, place);
    }

    private void Fill(JsonElement list, string name, Span<double> numbers, params ReadOnlySpan<int> places)
    {
        int index = 0;
        foreach (JsonElement item in list.EnumerateArray())
        {
            if (!IsFinite(item, out numbers[index]))
            {
                throw Wrong(Place(name, [.. places, index]), "a finite number, 1e12 at most", item);
            }

            index++;
        }
    }

    private static bool IsFinite(JsonElement field, out double value)
    {
        value = 0;
        return field.ValueKind == JsonValueKind.Number && field.TryGetDouble(out value) && Math.Abs(value) <= MaxMagnitude;
    }

    private bool BooleanOf(JsonElement field, string name, params ReadOnlySpan<int> places) =>
        field.ValueKind is JsonValueKind.True or JsonValueKind.False
            ? field.GetBoolean()
            : throw Wrong(Place(name, places), "true or false", field);

    /// <summary>The path of an item of a field, such as camera.position[2]; built for errors only.</summary>
    private string Place(string name, params ReadOnlySpan<int> places)
    {
        string path = Path(name);
        foreach (int place in places)
        {
            path += FormattableString.Invariant($"[{place}]");
        }

        return path;
    }

    private static DatasetFormatException Wrong(string path, string expected, JsonElement found)
    {
        const int longestQuote = 40;
        string text = found.GetRawText();
        string quote = text.Length <= longestQuote ? text : text[..longestQuote] + "...";
        return new DatasetFormatException($"{path} must be {expected}, not {quote.ReplaceLineEndings(" ")}.");
    }

    private JsonElement Field(string name) =>
        _element.TryGetProperty(name, out JsonElement field) ? field : throw new DatasetFormatException($"{Path(name)} is missing.");

    private string Path(string name) => _path.Length == 0 ? name : $"{_path}.{name}";
}
