using System.Security.Cryptography;
using System.Text;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Tokens: 32 hexadecimal digits that follow from what they stand for, so that every export has the same.</summary>
internal static class NuScenesToken
{
    private const int Digits = 32;

    /// <summary>The token of a thing.</summary>
    /// <param name="kind">Its table.</param>
    /// <param name="parts">What identifies it in the table.</param>
    public static string Of(string kind, params ReadOnlySpan<object> parts)
    {
        var text = new StringBuilder(kind);
        foreach (object part in parts)
        {
            text.Append('/').Append(FormattableString.Invariant($"{part}"));
        }

        return Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text.ToString())))[..Digits];
    }
}
