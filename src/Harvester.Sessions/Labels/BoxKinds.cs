using System.Collections.Generic;

namespace Harvester.Sessions.Labels;

/// <summary>The kinds of boxes that a label has.</summary>
public static class BoxKinds
{
    private static readonly BoxKind[] OfCuboid = [BoxKind.Cuboid, BoxKind.Amodal];
    private static readonly BoxKind[] All = [BoxKind.Cuboid, BoxKind.Amodal, BoxKind.Visible];

    /// <summary>The boxes of a label; those of the cuboid are always known.</summary>
    /// <param name="isVisibleKnown">Whether the label has the box of its visible pixels.</param>
    public static IReadOnlyList<BoxKind> Known(bool isVisibleKnown) => isVisibleKnown ? All : OfCuboid;
}
