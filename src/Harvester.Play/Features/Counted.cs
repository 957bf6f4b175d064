using System.Globalization;

namespace Harvester.Play.Features;

/// <summary>Numbers of things in messages.</summary>
internal static class Counted
{
    /// <summary>A number and a noun, such as "1 frame" or "2 frames".</summary>
    /// <param name="count">How many there are.</param>
    /// <param name="noun">The noun in the singular; its plural ends in s.</param>
    public static string Of(long count, string noun) =>
        count.ToString(CultureInfo.InvariantCulture) + " " + (count == 1 ? noun : noun + "s");
}
