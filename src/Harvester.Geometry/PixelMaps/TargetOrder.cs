namespace Harvester.Geometry.PixelMaps;

/// <summary>Sorts targets, so that the order in which they are given does not matter, and rejects ambiguous ones.</summary>
internal static class TargetOrder
{
    public static List<MapTarget> ByNumber(IReadOnlyList<MapTarget> targets)
    {
        var ordered = new List<MapTarget>(targets);
        ordered.Sort(static (a, b) => a.Number.CompareTo(b.Number));
        var entities = new HashSet<int>();
        for (int i = 0; i < ordered.Count; i++)
        {
            if (ordered[i].Number == 0 || (i > 0 && ordered[i].Number == ordered[i - 1].Number) || !entities.Add(ordered[i].Entity))
            {
                throw new ArgumentException("Every target has a handle and a number of its own, and 0 is no number.", nameof(targets));
            }
        }

        return ordered;
    }
}
