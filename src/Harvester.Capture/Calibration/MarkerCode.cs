namespace Harvester.Capture.Calibration;

/// <summary>
/// Which markers are shown in which of seven pictures. Each marker has a combination of exactly three pictures of its own, which identifies
/// it. A spot in fewer or more pictures is not a marker, or a marker that is partly hidden.
/// </summary>
internal static class MarkerCode
{
    /// <summary>The number of pictures.</summary>
    public const int Pictures = 7;

    private const int Weight = 3;

    private static readonly int[] Codes =
    [
        .. Enumerable.Range(0, 1 << Pictures).Where(code => Enumerable.Range(0, Pictures).Count(picture => IsIn(code, picture)) == Weight),
    ];

    /// <summary>The number of distinct markers: 35, the ways to choose three of seven.</summary>
    public static int Capacity => Codes.Length;

    /// <summary>Whether a marker is shown in a picture.</summary>
    public static bool IsShown(int marker, int picture) => IsIn(Codes[marker], picture);

    /// <summary>The marker that is shown in exactly these pictures; -1 if there is none.</summary>
    public static int MarkerIn(IEnumerable<int> pictures) =>
        System.Array.IndexOf(Codes, pictures.Aggregate(0, (code, picture) => code | (1 << picture)));

    private static bool IsIn(int code, int picture) => (code & (1 << picture)) != 0;
}
