using System.Globalization;

namespace Harvester.Cli.Terminals;

/// <summary>Numbers of things in words for people: 1 frame, 2 frames.</summary>
internal static class Counted
{
    /// <summary>So many of a thing.</summary>
    /// <param name="count">How many.</param>
    /// <param name="one">What one of them is called; more have an s.</param>
    public static string Of(long count, string one) =>
        string.Create(CultureInfo.InvariantCulture, $"{count} {one}{(count == 1 ? "" : "s")}");
}
