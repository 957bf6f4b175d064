using System.Collections.Concurrent;

namespace Harvester.Sessions.Roads;

/// <summary>Flags as text in files: their names in camelCase, joined by vertical bars; empty for no flag.</summary>
internal sealed class FlagNames<T>
    where T : struct, Enum
{
    /// <summary>A file cannot make the program remember more.</summary>
    private const int MaxKnown = 1_000;

    private readonly List<(string Name, int Value)> _flags = [];

    /// <summary>A road network has few different sets of flags.</summary>
    private readonly ConcurrentDictionary<string, int> _known = new(StringComparer.Ordinal);

    public FlagNames()
    {
        foreach (T value in (T[])Enum.GetValues(typeof(T)))
        {
            int number = Convert.ToInt32(value, System.Globalization.CultureInfo.InvariantCulture);
            string name = value.ToString();
            if (number != 0)
            {
                _flags.Add((char.ToLowerInvariant(name[0]) + name.Substring(1), number));
            }
        }
    }

    public string Write(int flags)
    {
        var names = new List<string>();
        foreach ((string name, int value) in _flags)
        {
            if ((flags & value) != 0)
            {
                names.Add(name);
            }
        }

        return string.Join("|", names);
    }

    /// <summary>The flags, or null if a name is unknown.</summary>
    public int? Read(string text)
    {
        int flags = 0;
        if (text.Length == 0 || _known.TryGetValue(text, out flags))
        {
            return flags;
        }

        foreach (string name in text.Split('|'))
        {
            int found = _flags.FindIndex(flag => string.Equals(flag.Name, name, StringComparison.Ordinal));
            if (found < 0)
            {
                return null;
            }

            flags |= _flags[found].Value;
        }

        if (_known.Count < MaxKnown)
        {
            _known[text] = flags;
        }

        return flags;
    }
}
