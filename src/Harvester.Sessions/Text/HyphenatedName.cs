namespace Harvester.Sessions.Text;

/// <summary>Names of several words in lower case with hyphens between them, as in options and folders.</summary>
internal static class HyphenatedName
{
    /// <summary>The name in lower case, with a hyphen before each capital letter but the first: depth, distance-bands.</summary>
    /// <param name="name">The name, with a capital letter at each word: Depth, DistanceBands or distanceBands.</param>
    public static string Of(string name) =>
        string.Concat(
            name.Select(
                static (letter, index) =>
                    char.IsUpper(letter) && index > 0 ? $"-{char.ToLowerInvariant(letter)}" : $"{char.ToLowerInvariant(letter)}"
            )
        );
}
