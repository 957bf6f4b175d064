using System;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Playing;

/// <summary>
/// Lets the world go on that nobody needs frozen any more. Whoever froze it does so first; where the game has refused that, it is
/// tried again in each tick.
/// </summary>
/// <param name="pause">The game's.</param>
/// <param name="isNeeded">Whether somebody may need the world frozen.</param>
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
