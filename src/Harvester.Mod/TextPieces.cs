using System.Collections.Generic;
using System.Text;

namespace Harvester.Mod;

/// <summary>A text in pieces as short as the game's texts take them.</summary>
internal static class TextPieces
{
    /// <summary>The game truncates a longer piece.</summary>
    private const int MaxBytes = 99;

    /// <summary>The pieces, which together are the text; none cuts a character in two.</summary>
    public static IEnumerable<string> Of(string text)
    {
        int start = 0;
        int bytes = 0;
        for (int i = 0; i < text.Length;)
        {
            int length = char.IsSurrogatePair(text, i) ? 2 : 1;
            int added = Encoding.UTF8.GetByteCount(text.Substring(i, length));
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
