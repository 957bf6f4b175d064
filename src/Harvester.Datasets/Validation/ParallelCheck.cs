using System.Runtime.ExceptionServices;

namespace Harvester.Datasets.Validation;

/// <summary>Checks several things at once, on all processors.</summary>
internal static class ParallelCheck
{
    /// <summary>Checks items.</summary>
    /// <param name="items">The items.</param>
    /// <param name="check">Checks an item; several are checked at once.</param>
    /// <param name="cancellation">Stops between two items.</param>
    /// <returns>The findings in the order of the items.</returns>
    public static TFinding[] Each<TItem, TFinding>(IReadOnlyList<TItem> items, Func<TItem, TFinding> check, CancellationToken cancellation)
    {
        var found = new TFinding[items.Count];
        try
        {
            Parallel.For(0, items.Count, new ParallelOptions { CancellationToken = cancellation }, i => found[i] = check(items[i]));
        }
        catch (AggregateException e)
        {
            // What a file that cannot be read throws is the command's to report.
            ExceptionDispatchInfo.Throw(e.InnerExceptions[0]);
        }

        return found;
    }
}
