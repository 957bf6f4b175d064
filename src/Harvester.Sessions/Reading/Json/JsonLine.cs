using System.Text;
using System.Text.Json;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Reading.Json;

/// <summary>Writes JSON on one line. Numbers are rounded, without exponent and minus zero, and the same on every system.</summary>
internal static class JsonLine
{
    /// <summary>The text that an action writes.</summary>
    public static string Of(Action<Utf8JsonWriter> write)
    {
        using var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes))
        {
            write(json);
        }

        return Encoding.UTF8.GetString(bytes.GetBuffer(), 0, (int)bytes.Length);
    }

    /// <summary>Writes a number, rounded to a number of decimals.</summary>
    public static void Value(this Utf8JsonWriter json, double value, int decimals) =>
        json.WriteRawValue(InvariantNumber.Format(value, decimals), skipInputValidation: true);

    /// <summary>Writes a named number, rounded to a number of decimals, or null.</summary>
    public static void Number(this Utf8JsonWriter json, string name, double? value, int decimals)
    {
        json.WritePropertyName(name);
        if (value is { } known)
        {
            json.Value(known, decimals);
        }
        else
        {
            json.WriteNullValue();
        }
    }

    /// <summary>Writes a named list of numbers.</summary>
    public static void Numbers(this Utf8JsonWriter json, string name, ReadOnlySpan<double> values, int decimals)
    {
        json.WritePropertyName(name);
        json.Values(values, decimals);
    }

    /// <summary>Writes a list of numbers.</summary>
    public static void Values(this Utf8JsonWriter json, ReadOnlySpan<double> values, int decimals)
    {
        json.WriteStartArray();
        foreach (double value in values)
        {
            json.Value(value, decimals);
        }

        json.WriteEndArray();
    }
}
