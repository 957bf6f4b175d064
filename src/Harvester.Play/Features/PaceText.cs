namespace Harvester.Play.Features;

/// <summary>The pace of a harvest, as the player reads it.</summary>
internal static class PaceText
{
    /// <summary>How long a minute of driving takes.</summary>
    /// <param name="pace">Real time for a second of game time, seconds; null if it is not measured yet.</param>
    /// <returns>Empty if it is not measured yet.</returns>
    public static string Of(double? pace) =>
        pace is { } measured ? FormattableString.Invariant($"1 minute of driving takes {measured:0.#}") : string.Empty;
}
