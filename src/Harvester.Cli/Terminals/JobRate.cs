namespace Harvester.Cli.Terminals;

/// <summary>
/// The rate of a job, measured from the first report on. Work before that, such as building a world or reading a session, happens once
/// and is not part of the rate.
/// </summary>
internal sealed class JobRate
{
    /// <summary>A rate measured over less time is not reported.</summary>
    private static readonly TimeSpan MinTime = TimeSpan.FromSeconds(1);

    private (int Done, TimeSpan At)? _first;

    /// <summary>Takes a report.</summary>
    /// <param name="done">The work done so far.</param>
    /// <param name="at">Time of the report, from any fixed start.</param>
    /// <returns>The rate per second; null while it is unknown.</returns>
    public double? Report(int done, TimeSpan at)
    {
        _first ??= (done, at);
        (int firstDone, TimeSpan firstAt) = _first.Value;
        return done > firstDone && at - firstAt >= MinTime ? (done - firstDone) / (at - firstAt).TotalSeconds : null;
    }
}
