using System;
using System.Linq;
using System.Threading;

namespace Harvester.Capture.Playing;

/// <summary>
/// The features of a mod. No exception of theirs leaves: a feature that fails is stopped with a message, and the others go on.
/// </summary>
/// <param name="messages">Where failures are told.</param>
/// <param name="features">The features, in the order of their ticks.</param>
public sealed class FeatureSet(PlayerMessages messages, params IFeature[] features)
{
    private static readonly TimeSpan LongestWaitForTheLog = TimeSpan.FromSeconds(2);

    /// <summary>Whether work of any of them goes on on another thread.</summary>
    public bool IsBusy => messages.IsBusy || features.OfType<ILastingFeature>().Any(feature => feature.IsBusy);

    /// <summary>Does one frame's work.</summary>
    public void Tick()
    {
        foreach (IFeature feature in features)
        {
            Do(feature, feature.Tick);
        }
    }

    /// <summary>Ends all features for good. First each gives back what it has of the game, in the opposite order of their ticks; only then the disk is waited for.</summary>
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

        messages.Wait(LongestWaitForTheLog);
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
