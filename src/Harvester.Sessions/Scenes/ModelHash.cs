using System.Globalization;

namespace Harvester.Sessions.Scenes;

/// <summary>The game's hash of a model: Bob Jenkins's one-at-a-time hash of its name in lower case.</summary>
public static class ModelHash
{
    /// <summary>The hash of a model's name, as the scripting API gives it: a signed 32-bit number.</summary>
    /// <param name="model">The name, ASCII; upper and lower case are equivalent.</param>
    /// <exception cref="ArgumentNullException"><paramref name="model"/> is null.</exception>
    public static int Of(string model)
    {
        if (model is null)
        {
            throw new ArgumentNullException(nameof(model));
        }
        unchecked
        {
            uint hash = 0;
            foreach (char letter in model)
            {
                hash += letter is >= 'A' and <= 'Z' ? (uint)(letter + ('a' - 'A')) : letter;
                hash += hash << 10;
                hash ^= hash >> 6;
            }

            hash += hash << 3;
            hash ^= hash >> 11;
            hash += hash << 15;
            return (int)hash;
        }
    }

    /// <summary>Parses a hash: a signed or unsigned decimal number, or 0x and hexadecimal digits.</summary>
    public static bool TryParse(string text, out int hash)
    {
        hash = 0;
        if (text is null)
        {
            return false;
        }

        bool isHexadecimal = text.StartsWith("0x", StringComparison.OrdinalIgnoreCase);
        bool isNumber = isHexadecimal
            ? long.TryParse(text.Substring(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out long value)
            : long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);
        if (!isNumber || value < int.MinValue || value > uint.MaxValue)
        {
            return false;
        }

        hash = unchecked((int)value);
        return true;
    }
}
