using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// Resumes a world that no feature needs frozen any more. The feature that froze it does so first; if the game refused, this tries again in
/// every tick.
/// </summary>
/// <param name="pause">The game's pause.</param>
/// <param name="isNeeded">Whether a feature may need the world frozen.</param>
public sealed class FrozenWorld(IPause pause, Func<bool> isNeeded) : IFeature
{
    /// <inheritdoc/>
    public string Name => "Letting the world go on";

    /// <inheritdoc/>
    public bool IsOn => false;

    /// <inheritdoc/>
    public void Tick()
    {
        if (!isNeeded())
        {
            pause.Unfreeze();
        }
    }

    /// <inheritdoc/>
    public void Stop() => pause.Unfreeze();
}
