namespace Harvester.Reports.Sessions;

/// <summary>Selects evenly spaced items of a sequence, including the first and the last.</summary>
public static class EvenSelection
{
    /// <summary>The selected indices, ascending.</summary>
    /// <param name="count">Number of items; 0 or more.</param>
    /// <param name="max">Largest number of items to select; at least 1.</param>
    public static IReadOnlyList<int> Of(int count, int max)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfLessThan(max, 1);
        int chosen = Math.Min(count, max);
        return chosen == 1 ? [0] : [.. Enumerable.Range(0, chosen).Select(i => (int)((long)i * (count - 1) / (chosen - 1)))];
    }
}
