namespace Harvester.Sessions.Text;

/// <summary>The names of enumeration values in files: with a lower-case first letter.</summary>
public static class JsonName
{
    /// <summary>The name of a value, such as trafficLight.</summary>
    public static string Of<T>(T value)
        where T : struct, Enum
    {
        string name = value.ToString();
        return char.ToLowerInvariant(name[0]) + name.Substring(1);
    }
}
