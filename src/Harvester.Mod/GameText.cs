namespace Harvester.Mod;

/// <summary>Texts for the game's screen.</summary>
internal static class GameText
{
    /// <summary>Begins and ends the game's markup, such as ~r~ for red; the game has no other way to write the character.</summary>
    private const char Markup = '~';

    /// <summary>A small tilde, which looks alike and has no meaning to the game.</summary>
    private const char Alike = '\u02DC';

    /// <summary>The text without markup: what is shown is what was meant.</summary>
    public static string Plain(string text) => text.Replace(Markup, Alike);
}
