using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// The features of a mod. Their exceptions are caught: a feature that fails is stopped with a message, and the others continue.
/// </summary>
/// <param name="messages">Reports failures and logs the cost of the features.</param>
/// <param name="calls">Counts the calls to the game.</param>
/// <param name="clock">Real time.</param>
/// <param name="features">The features, in the order of their ticks.</param>
public sealed class FeatureSet(PlayerMessages messages, ICallCounter calls, IClock clock, params IFeature[] features)
{
    private static readonly TimeSpan MaxWaitForLog = TimeSpan.FromSeconds(2);

    private readonly FeatureWatch[] _watches = [.. features.Select(feature => new FeatureWatch(feature, messages, calls, clock))];

    /// <summary>Whether work of any feature continues on another thread.</summary>
    public bool IsBusy => messages.IsBusy || features.OfType<ILastingFeature>().Any(feature => feature.IsBusy);

    /// <summary>Does one frame's work.</summary>
    public void Tick()
    {
        foreach (FeatureWatch watch in _watches)
        {
            (long, long, double) before = watch.Before;
            try
            {
                watch.Feature.Tick();
            }
#pragma warning disable CA1031 // The game's loader ends a script for any exception of its.
            catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
            {
                TellFailure(watch.Feature.Name, exception);
                Try(watch.Feature.Name, watch.Feature.Stop);
            }

            watch.After(before);
        }
    }

    /// <summary>
    /// Ends all features for good. First each releases what it has of the game, in reverse order of their ticks; only then it waits for the
    /// disk.
    /// </summary>
    public void Finish()
    {
        foreach (IFeature feature in features.Reverse())
        {
            Try(feature.Name, feature.Stop);
        }

        foreach (ILastingFeature feature in features.OfType<ILastingFeature>())
        {
            Try(feature.Name, feature.Finish);
        }

        foreach (FeatureWatch watch in _watches)
        {
            watch.LogEnd();
        }

        messages.Wait(MaxWaitForLog);
    }

    /// <summary>Runs an action of a feature; if it fails, the feature is stopped.</summary>
    public void Do(IFeature feature, Action work)
    {
        if (feature is not null && !Try(feature.Name, work))
        {
            Try(feature.Name, feature.Stop);
        }
    }

    /// <summary>Runs an action; a failure is reported under a name.</summary>
    /// <returns>Whether it succeeded.</returns>
    public bool Try(string name, Action work)
    {
        try
        {
            (work ?? throw new ArgumentNullException(nameof(work)))();
            return true;
        }
#pragma warning disable CA1031 // The game's loader ends a script for any exception of its.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            TellFailure(name, exception);
            return false;
        }
    }

    private void TellFailure(string name, Exception exception) =>
        messages.TellFailure(name, exception is AggregateException { InnerExceptions: { Count: 1 } inner } ? inner[0] : exception);
}
