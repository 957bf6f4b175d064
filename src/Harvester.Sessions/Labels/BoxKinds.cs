namespace Harvester.Sessions.Labels;

/// <summary>The kinds of boxes that a label has.</summary>
public static class BoxKinds
{
    private static readonly BoxKind[] OfCuboid = [BoxKind.Cuboid, BoxKind.Amodal];
    private static readonly BoxKind[] WithVisible = [.. OfCuboid, BoxKind.Visible];
    private static readonly BoxKind[] WithWhole = [.. OfCuboid, BoxKind.Whole];
    private static readonly BoxKind[] All = [.. WithVisible, BoxKind.Whole];

    /// <summary>The boxes of a label; those of the cuboid are always known.</summary>
    /// <param name="isVisibleKnown">Whether the label has the box of its visible pixels.</param>
    /// <param name="isWholeKnown">Whether it has the box of all its pixels, hidden ones included.</param>
    public static IReadOnlyList<BoxKind> Known(bool isVisibleKnown, bool isWholeKnown = false) =>
        (isVisibleKnown, isWholeKnown) switch
        {
            (true, true) => All,
            (true, false) => WithVisible,
            (false, true) => WithWhole,
            _ => OfCuboid,
        };
}
