using Harvester.Sessions.Text;

namespace Harvester.Sessions.Reading.Json;

/// <summary>Reads the names of enumeration values in files.</summary>
public static class JsonNames
{
    /// <summary>The names of all values, in the order of the enumeration.</summary>
    public static IEnumerable<string> All<T>()
        where T : struct, Enum => Known<T>.Names;

    /// <summary>Reads a name; case-sensitive.</summary>
    public static bool TryRead<T>(string name, out T value)
        where T : struct, Enum
    {
        int place = Array.IndexOf(Known<T>.Names, name);
        value = place < 0 ? default : Known<T>.Values[place];
        return place >= 0;
    }

    /// <summary>The values of an enumeration and their names, made once: a label has names by the hundred.</summary>
    private static class Known<T>
        where T : struct, Enum
    {
        public static readonly T[] Values = Enum.GetValues<T>();
        public static readonly string[] Names = Array.ConvertAll(Values, JsonName.Of);
    }
}
