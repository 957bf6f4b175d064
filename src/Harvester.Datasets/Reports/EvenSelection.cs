using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Datasets.Reports;

/// <summary>Chooses some of a row of things at even distances, the first and the last among them.</summary>
public static class EvenSelection
{
    /// <summary>The chosen indices, rising.</summary>
    /// <param name="count">How many things there are; 0 or more.</param>
    /// <param name="most">How many to choose at most; at least 1.</param>
    public static IReadOnlyList<int> Of(int count, int most)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfLessThan(most, 1);
        int chosen = Math.Min(count, most);
        return chosen == 1 ? [0] : [.. Enumerable.Range(0, chosen).Select(i => (int)((long)i * (count - 1) / (chosen - 1)))];
    }
}
