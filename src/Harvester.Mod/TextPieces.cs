using System.Text;

namespace Harvester.Mod;

/// <summary>Splits texts into pieces that are short enough for the game.</summary>
internal static class TextPieces
{
    /// <summary>The game truncates a longer piece.</summary>
    private const int MaxBytes = 99;

    /// <summary>The pieces of a text, in order. No character is split.</summary>
    public static IEnumerable<string> Of(string text)
    {
        char[] characters = text.ToCharArray();
        int start = 0;
        int bytes = 0;
        for (int i = 0; i < text.Length; )
        {
            int length = char.IsSurrogatePair(text, i) ? 2 : 1;
            int added = Encoding.UTF8.GetByteCount(characters, i, length);
            if (bytes + added > MaxBytes)
            {
                yield return text.Substring(start, i - start);
                (start, bytes) = (i, 0);
            }

            bytes += added;
            i += length;
        }

        yield return text.Substring(start);
    }
}
