namespace Harvester.Sessions.Reading.Files;

/// <summary>Does independent work on the items of a sequence on all processors, a few items ahead of the one that is asked for.</summary>
internal static class ReadAhead
{
    private static readonly int Ahead = 4 * Environment.ProcessorCount;

    /// <summary>The results in the order of the items; what the work throws is thrown where its result would be.</summary>
    /// <param name="items">The items; they are asked for by the caller's thread, and only as far ahead as results are kept.</param>
    /// <param name="work">The work; several threads do it at a time.</param>
    public static IEnumerable<TResult> Select<T, TResult>(IEnumerable<T> items, Func<T, TResult> work)
    {
        var begun = new Queue<Task<TResult>>(Ahead);
        foreach (T item in items)
        {
            if (begun.Count == Ahead)
            {
                yield return begun.Dequeue().GetAwaiter().GetResult();
            }

            begun.Enqueue(Task.Run(() => work(item)));
        }

        while (begun.TryDequeue(out Task<TResult>? next))
        {
            yield return next.GetAwaiter().GetResult();
        }
    }
}
