using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Rigs;

/// <summary>
/// An object of a rig file, whose fields are read by name. Every error is a <see cref="FormatException"/> that names the field by its
/// path, such as cameras[1].width.
/// </summary>
internal sealed class RigFields
{
    private readonly Dictionary<string, object?> _values;
    private readonly string _path;
    private readonly HashSet<string> _read = new(StringComparer.Ordinal);

    private RigFields(Dictionary<string, object?> values, string path) => (_values, _path) = (values, path);

    /// <summary>Parses the outermost object of a text.</summary>
    public static RigFields Parse(string text)
    {
        var json = new JsonReader(text);
        object? value = ValueOf(json);
        json.End();
        return Of(value, "");
    }

    public bool Has(string name) => _values.TryGetValue(name, out object? value) && value is not null;

    public string Text(string name) => Required(name) is string text ? text : throw Wrong(name, "a text");

    public double Number(string name, double minimum, double maximum) => Checked(name, Required(name), minimum, maximum);

    public double Number(string name, double minimum, double maximum, double otherwise) =>
        Has(name) ? Number(name, minimum, maximum) : Skipped(name, otherwise);

    public int Whole(string name, int minimum, int maximum)
    {
        double number = Number(name, minimum, maximum);
        return Math.Floor(number).Equals(number) ? (int)number : throw Wrong(name, "a whole number");
    }

    public bool Flag(string name, bool otherwise) => !Has(name) ? Skipped(name, otherwise)
        : Required(name) is bool flag ? flag : throw Wrong(name, "true or false");

    public double[] Numbers(string name, double minimum, double maximum) => Required(name) is List<object?> list
        ? [.. list.Select((item, index) => Checked($"{name}[{Text(index)}]", item, minimum, maximum))]
        : throw Wrong(name, "a list of numbers");

    public Vector3D Vector(string name, double limit)
    {
        double[] numbers = Numbers(name, -limit, limit);
        return numbers.Length == 3 ? new Vector3D(numbers[0], numbers[1], numbers[2])
            : throw Wrong(name, "three numbers: right, forward and up, in metres");
    }

    public RigFields? Fields(string name) => Has(name) ? Of(Required(name), PathOf(name)) : Skipped<RigFields?>(name, null);

    public RigFields[] List(string name)
    {
        if (!Has(name))
        {
            return Skipped<RigFields[]>(name, []);
        }

        return Required(name) is List<object?> list
            ? [.. list.Select((item, index) => Of(item, $"{PathOf(name)}[{Text(index)}]"))]
            : throw Wrong(name, "a list of objects");
    }

    /// <summary>Refuses fields that nothing has read.</summary>
    public void End()
    {
        if (_values.Keys.FirstOrDefault(name => !_read.Contains(name)) is { } unknown)
        {
            throw new FormatException($"{PathOf(unknown)} is not a field of a rig. Correct its name or delete it.");
        }
    }

    /// <summary>The error that a field is not what it must be.</summary>
    public FormatException Wrong(string name, string wanted) => new($"{PathOf(name)} must be {wanted}.");

    private static RigFields Of(object? value, string path) => value is Dictionary<string, object?> values ? new RigFields(values, path)
        : throw new FormatException($"{(path.Length == 0 ? "the file" : path)} must be an object.");

    private double Checked(string name, object? value, double minimum, double maximum) =>
        value is double number && number >= minimum && number <= maximum ? number
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
