using System.Text;

namespace Harvester.Mod.Tests;

public sealed class TextPiecesTests
{
    private const int MaxBytes = 99;

    public static TheoryData<string, int> Texts() =>
        new()
        {
            { string.Empty, 1 },
            { new string('a', 99), 1 },
            { new string('a', 100), 2 },
            { new string('é', 99), 3 },
            { new string('a', 98) + "é", 2 },
            { new string('a', 96) + "\U0001F697", 2 },
            { string.Concat(Enumerable.Repeat("\U0001F697", 25)), 2 },
        };

    [Theory]
    [MemberData(nameof(Texts))]
    public void Pieces_fit_the_game_and_together_give_the_text(string text, int pieces)
    {
        string[] found = [.. TextPieces.Of(text)];

        Assert.Equal(pieces, found.Length);
        Assert.Equal(text, string.Concat(found));
        Assert.All(found, piece => Assert.InRange(new UTF8Encoding(false, throwOnInvalidBytes: true).GetByteCount(piece), 0, MaxBytes));
    }
}
