using System;
using System.Linq;
using System.Threading;
using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// The features of a mod. No exception of theirs leaves: a feature that fails is stopped with a message, and the others go on.
/// </summary>
/// <param name="messages">Where failures are told, and what the features cost is logged.</param>
/// <param name="calls">Counts what is asked of the game.</param>
/// <param name="clock">The player's time.</param>
/// <param name="features">The features, in the order of their ticks.</param>
public sealed class FeatureSet(PlayerMessages messages, ICallCounter calls, IClock clock, params IFeature[] features)
{
    private static readonly TimeSpan MaxWaitForLog = TimeSpan.FromSeconds(2);

    private readonly FeatureWatch[] _watches = [.. features.Select(feature => new FeatureWatch(feature, messages, calls, clock))];

    /// <summary>Whether work of any of them goes on on another thread.</summary>
    public bool IsBusy => messages.IsBusy || features.OfType<ILastingFeature>().Any(feature => feature.IsBusy);

    /// <summary>Does one frame's work.</summary>
    public void Tick()
    {
        foreach (FeatureWatch watch in _watches)
        {
            (long, long, double) before = watch.Before;
            Do(watch.Feature, watch.Feature.Tick);
            watch.After(before);
        }
    }

    /// <summary>
    /// Ends all features for good. First each gives back what it has of the game, in the opposite order of their ticks; only then the disk
    /// is waited for.
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

    /// <summary>Lets a feature work; it is stopped when it fails.</summary>
    public void Do(IFeature feature, Action work)
    {
        if (feature is not null && !Try(feature.Name, work))
        {
            Try(feature.Name, feature.Stop);
        }
    }

    /// <summary>Works in the name of something; tells a failure.</summary>
    /// <returns>Whether it did not fail.</returns>
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
            messages.TellFailure(name, exception is AggregateException { InnerExceptions: { Count: 1 } inner } ? inner[0] : exception);
            return false;
        }
    }
}
