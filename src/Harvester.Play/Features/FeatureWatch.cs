using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>Logs when a feature goes on and off, and its cost in between.</summary>
/// <param name="feature">The feature.</param>
/// <param name="messages">Writes the log.</param>
/// <param name="calls">Counts the calls to the game.</param>
/// <param name="clock">Real time.</param>
internal sealed class FeatureWatch(IFeature feature, PlayerMessages messages, ICallCounter calls, IClock clock)
{
    private FeatureFigures? _figures;

    public IFeature Feature => feature;

    /// <summary>The calls to the game so far, and the time: read before a tick and passed to <see cref="After"/>.</summary>
    public (long Natives, long Rays, double Milliseconds) Before => (calls.Natives, calls.Rays, clock.Milliseconds);

    /// <summary>Called after each tick of the feature.</summary>
    public void After((long Natives, long Rays, double Milliseconds) before)
    {
        if (_figures is null && !feature.IsOn)
        {
            return;
        }

        if (_figures is null)
        {
            _figures = new FeatureFigures(calls, clock);
            messages.Log($"{feature.Name}: on");
        }

        _figures.Add(before);
        LogEnd();
    }

    /// <summary>Logs the figures once the feature is off.</summary>
    public void LogEnd()
    {
        if (_figures is { } figures && !feature.IsOn)
        {
            _figures = null;
            messages.Log($"{feature.Name}: off after {figures}");
        }
    }
}
