using System.Globalization;

namespace Harvester.Sessions.Text;

/// <summary>Counts in messages: 1 frame, 2 frames.</summary>
public static class Counted
{
    /// <summary>A count with its noun.</summary>
    /// <param name="count">The count.</param>
    /// <param name="one">The noun in the singular; the plural is formed with an s.</param>
    public static string Of(long count, string one) => count.ToString(CultureInfo.InvariantCulture) + " " + (count == 1 ? one : one + "s");
}
