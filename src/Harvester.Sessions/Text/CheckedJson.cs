using System.Globalization;
using Harvester.Geometry;

namespace Harvester.Sessions.Text;

/// <summary>
/// An object of a JSON file, whose fields are read by name. Every error is a <see cref="FormatException"/> that names the field by its
/// path, such as cameras[1].width.
/// </summary>
internal sealed class CheckedJson
{
    private readonly Dictionary<string, object?> _values;
    private readonly string _path;
    private readonly string _kind;
    private readonly HashSet<string> _read = new(StringComparer.Ordinal);

    /// <summary>Values for texts that stand for numbers; null where none do.</summary>
    private readonly NumberTerms? _terms;

    private CheckedJson(Dictionary<string, object?> values, string path, string kind, NumberTerms? terms) =>
        (_values, _path, _kind, _terms) = (values, path, kind, terms);

    /// <summary>Parses the outermost object of a text.</summary>
    /// <param name="text">The text.</param>
    /// <param name="kind">What the file describes, with an article, for messages.</param>
    /// <param name="terms">Values for texts that stand for numbers; null where none do.</param>
    public static CheckedJson Parse(string text, string kind, NumberTerms? terms = null)
    {
        var json = new JsonReader(text);
        object? value = ValueOf(json);
        json.End();
        return Of(value, "", kind, terms);
    }

    public bool Has(string name) => _values.TryGetValue(name, out object? value) && value is not null;

    public string Text(string name) => Required(name) is string text ? text : throw Wrong(name, "a text");

    public double Number(string name, double minimum, double maximum) => Checked(name, Required(name), minimum, maximum);

    public double Number(string name, double minimum, double maximum, double otherwise) =>
        Has(name) ? Number(name, minimum, maximum) : Skipped(name, otherwise);

    public string Text(string name, string otherwise) => Has(name) ? Text(name) : Skipped(name, otherwise);

    public int Whole(string name, int minimum, int maximum, int otherwise) =>
        Has(name) ? Whole(name, minimum, maximum) : Skipped(name, otherwise);

    public int Whole(string name, int minimum, int maximum)
    {
        double number = Number(name, minimum, maximum);
        return Math.Floor(number).Equals(number) ? (int)number : throw Wrong(name, "a whole number");
    }

    public bool Flag(string name, bool otherwise) =>
        !Has(name) ? Skipped(name, otherwise)
        : Required(name) is bool flag ? flag
        : throw Wrong(name, "true or false");

    /// <summary>A value of an enumeration by its name in files.</summary>
    public T Choice<T>(string name)
        where T : struct, Enum => ChoiceOf<T>(name, Text(name));

    public T Choice<T>(string name, T otherwise)
        where T : struct, Enum => Has(name) ? Choice<T>(name) : Skipped(name, otherwise);

    public T[] Choices<T>(string name)
        where T : struct, Enum => [.. Texts(name).Select(text => ChoiceOf<T>(name, text))];

    public double[] Numbers(string name, double minimum, double maximum) =>
        Required(name) is List<object?> list
            ? [.. list.Select((item, index) => Checked($"{name}[{Text(index)}]", item, minimum, maximum))]
            : throw Wrong(name, "a list of numbers");

    public string[] Texts(string name) =>
        Required(name) is List<object?> list
            ? [.. list.Select((item, index) => item as string ?? throw Wrong($"{name}[{Text(index)}]", "a text"))]
            : throw Wrong(name, "a list of texts");

    /// <summary>Points of the ground, each a list of x and y.</summary>
    public Vector2D[] Points(string name, double limit) =>
        Required(name) is List<object?> list
            ?
            [
                .. list.Select(
                    (item, index) =>
                        item is List<object?> { Count: 2 } pair
                            ? new Vector2D(
                                Checked($"{name}[{Text(index)}][0]", pair[0], -limit, limit),
                                Checked($"{name}[{Text(index)}][1]", pair[1], -limit, limit)
                            )
                            : throw Wrong($"{name}[{Text(index)}]", "two numbers: x and y, in metres")
                ),
            ]
            : throw Wrong(name, "a list of points");

    public Vector3D Vector(string name, double limit)
    {
        double[] numbers = Numbers(name, -limit, limit);
        return numbers.Length == 3
            ? new Vector3D(numbers[0], numbers[1], numbers[2])
            : throw Wrong(name, "three numbers: right, forward and up, in metres");
    }

    public CheckedJson? Fields(string name) =>
        Has(name) ? Of(Required(name), PathOf(name), _kind, _terms) : Skipped<CheckedJson?>(name, null);

    public CheckedJson[] List(string name)
    {
        if (!Has(name))
        {
            return Skipped<CheckedJson[]>(name, []);
        }

        return Required(name) is List<object?> list
            ? [.. list.Select((item, index) => Of(item, $"{PathOf(name)}[{Text(index)}]", _kind, _terms))]
            : throw Wrong(name, "a list of objects");
    }

    /// <summary>The names of the fields, in the order of the file.</summary>
    public IEnumerable<string> Names => _values.Keys;

    /// <summary>Whether a field is a list.</summary>
    public bool IsList(string name) => _values.TryGetValue(name, out object? value) && value is List<object?>;

    /// <summary>Whether a field is an object.</summary>
    public bool IsObject(string name) => _values.TryGetValue(name, out object? value) && value is Dictionary<string, object?>;

    /// <summary>Refuses fields that nothing has read.</summary>
    public void End()
    {
        if (Unknown.FirstOrDefault() is { } unknown)
        {
            throw new FormatException(unknown);
        }
    }

    /// <summary>A message for each field that nothing has read.</summary>
    public IEnumerable<string> Unknown =>
        _values
            .Keys.Where(name => !_read.Contains(name))
            .Select(name => $"{PathOf(name)} is not a field of {_kind}. Correct its name or delete it.");

    /// <summary>The error that a field is not what it must be.</summary>
    public FormatException Wrong(string name, string wanted) => new($"{PathOf(name)} must be {wanted}.");

    private static CheckedJson Of(object? value, string path, string kind, NumberTerms? terms) =>
        value is Dictionary<string, object?> values
            ? new CheckedJson(values, path, kind, terms)
            : throw new FormatException($"{(path.Length == 0 ? "the file" : path)} must be an object.");

    private T ChoiceOf<T>(string name, string text)
        where T : struct, Enum
    {
        T[] values = [.. Enum.GetValues(typeof(T)).Cast<T>()];
        int found = Array.FindIndex(values, value => JsonName.Of(value) == text);
        return found >= 0
            ? values[found]
            : throw Wrong(name, $"one of {string.Join(", ", values.Select(value => JsonName.Of(value)))}, not '{text}'");
    }

    private double Checked(string name, object? value, double minimum, double maximum) =>
        (value is string term && _terms is not null ? _terms.ValueOf(term) : value) is double number
        && number >= minimum
        && number <= maximum
            ? number
            : throw Wrong(name, FormattableString.Invariant($"a number from {minimum} to {maximum}"));

    private object? Required(string name)
    {
        _read.Add(name);
        return Has(name) ? _values[name] : throw new FormatException($"{PathOf(name)} is missing.");
    }

    private T Skipped<T>(string name, T value)
    {
        _read.Add(name);
        return value;
    }

    private string PathOf(string name) => _path.Length == 0 ? name : $"{_path}.{name}";

    private static string Text(int index) => index.ToString(CultureInfo.InvariantCulture);

    private static object? ValueOf(JsonReader json)
    {
        switch (json.Next)
        {
            case '{':
                var values = new Dictionary<string, object?>(StringComparer.Ordinal);
                json.Object(name =>
                {
                    object? value = ValueOf(json);
                    values[name] = values.ContainsKey(name) ? throw new FormatException($"the field {name} is given twice.") : value;
                });
                return values;
            case '[':
                var list = new List<object?>();
                json.List(() => list.Add(ValueOf(json)));
                return list;
            case '"':
                return json.String();
            case 't' or 'f':
                return json.Boolean();
            case 'n':
                json.Null();
                return null;
            default:
                return json.Number();
        }
    }
}
