namespace Harvester.Sessions.Text;

/// <summary>
/// An object of a JSON text whose fields are read by name. Every error is the exception of its reader and names the field.
/// </summary>
public interface IJsonFields
{
    /// <summary>Whether a field exists and is not null.</summary>
    bool Has(string name);

    /// <summary>A 32-bit integer.</summary>
    int Integer(string name);

    /// <summary>A finite number.</summary>
    double Number(string name);

    /// <summary>A list of finite numbers.</summary>
    double[] Numbers(string name);

    /// <summary>A string.</summary>
    string Text(string name);

    /// <summary>A value of an enumeration; its name begins with a small letter.</summary>
    T Name<T>(string name)
        where T : struct, Enum;

    /// <summary>A nested object.</summary>
    IJsonFields Fields(string name);

    /// <summary>A list of objects.</summary>
    IReadOnlyList<IJsonFields> List(string name);

    /// <summary>The exception for a field that is valid JSON and has an invalid value.</summary>
    Exception Refusal(string message);
}
