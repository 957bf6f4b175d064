using System;
using System.Collections.Generic;

namespace Harvester.Sessions.Roads;

/// <summary>Flags as files have them: their names with a small first letter, joined by vertical bars; nothing for none.</summary>
internal sealed class FlagNames<T>
    where T : struct, Enum
{
    private readonly List<(string Name, int Value)> _flags = [];

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

    /// <summary>The flags, or null when a name is not one of them.</summary>
    public int? Read(string text)
    {
        int flags = 0;
        if (text.Length == 0)
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

        return flags;
    }
}
