using System.Collections.Generic;
using System.Linq;

namespace Harvester.Capture.Calibration;

/// <summary>
/// Which markers are shown in which of several pictures, so that each is known by the pictures that show it: by exactly three of seven, another
/// three for each. What shows in fewer or more pictures is no marker, or not a whole one.
/// </summary>
internal static class MarkerCode
{
    /// <summary>The number of pictures.</summary>
    public const int Pictures = 7;

    private const int Weight = 3;

    private static readonly int[] Codes = [.. Enumerable.Range(0, 1 << Pictures).Where(code => Enumerable.Range(0, Pictures).Count(picture => IsIn(code, picture)) == Weight)];

    /// <summary>How many markers can be told apart: 35.</summary>
    public static int Capacity => Codes.Length;

    /// <summary>Whether a marker is shown in a picture.</summary>
    public static bool IsShown(int marker, int picture) => IsIn(Codes[marker], picture);

    /// <summary>The marker that is shown in some pictures and no other; -1 when there is none.</summary>
    public static int MarkerIn(IEnumerable<int> pictures) => System.Array.IndexOf(Codes, pictures.Aggregate(0, (code, picture) => code | (1 << picture)));

    private static bool IsIn(int code, int picture) => (code & (1 << picture)) != 0;
}
