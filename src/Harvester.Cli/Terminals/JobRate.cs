using System;

namespace Harvester.Cli.Terminals;

/// <summary>
/// How fast a job goes. It is measured from the first report on: what comes before, building a world or reading a session, happens once and
/// says nothing about the rest.
/// </summary>
internal sealed class JobRate
{
    /// <summary>Over less time than this, a rate is as good as any guess.</summary>
    private static readonly TimeSpan MinTime = TimeSpan.FromSeconds(1);

    private (int Done, TimeSpan At)? _first;

    /// <summary>Takes a report.</summary>
    /// <param name="done">What is done.</param>
    /// <param name="at">When, on any clock.</param>
    /// <returns>What is done in a second; null while that is not known.</returns>
    public double? Report(int done, TimeSpan at)
    {
        _first ??= (done, at);
        (int firstDone, TimeSpan firstAt) = _first.Value;
        return done > firstDone && at - firstAt >= MinTime ? (done - firstDone) / (at - firstAt).TotalSeconds : null;
    }
}
