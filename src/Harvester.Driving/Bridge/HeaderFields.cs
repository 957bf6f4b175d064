using Harvester.Sessions.Text;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The fields of one flat JSON object, whose values are strings, numbers, booleans, null or arrays of numbers: what clients send.
/// Anything else is rejected.
/// </summary>
internal sealed class HeaderFields
{
    private readonly Dictionary<string, object?> _values = new(StringComparer.Ordinal);

    private HeaderFields(JsonReader json)
    {
        json.Object(name =>
        {
            if (_values.ContainsKey(name))
            {
                throw json.Wrong($"the field {ClientText.Quoted(name)} again");
            }

            _values.Add(name, ValueOf(json));
        });
        json.End();
    }

    /// <exception cref="BridgeException">The text is not such an object.</exception>
    public static HeaderFields Parse(string text)
    {
        try
        {
            return new HeaderFields(new JsonReader(text));
        }
        catch (FormatException e)
        {
            throw new BridgeException($"the header is not a flat JSON object: {e.Message}.", e);
        }
    }

    public bool Has(string name) => _values.TryGetValue(name, out object? value) && value is not null;

    public string Text(string name) =>
        _values.TryGetValue(name, out object? value) && value is string text
            ? text
            : throw new BridgeException($"field {name} must be a string.");

    public double Number(string name) =>
        _values.TryGetValue(name, out object? value) && value is double number
            ? number
            : throw new BridgeException($"field {name} must be a number.");

    public bool Boolean(string name) =>
        _values.TryGetValue(name, out object? value) && value is bool truth
            ? truth
            : throw new BridgeException($"field {name} must be true or false.");

    public double[] Numbers(string name, int count) =>
        _values.TryGetValue(name, out object? value) && value is double[] numbers && numbers.Length == count
            ? numbers
            : throw new BridgeException(FormattableString.Invariant($"field {name} must be an array of {count} numbers."));

    private static object? ValueOf(JsonReader json)
    {
        switch (json.Next)
        {
            case '"':
                return json.String();
            case '[':
                var numbers = new List<double>();
                json.List(() => numbers.Add(json.Number()));
                return numbers.ToArray();
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
