using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Quirks;

/// <summary>The light of a sky that follows weather and time of day only gradually.</summary>
/// <param name="ticks">Number of ticks in which a new light fades in; 0, at once, or more.</param>
internal sealed class SkyFade(int ticks)
{
    private Lighting? _from;
    private int _left;

    /// <summary>Lets the light fade from the one that is shown now.</summary>
    public void Begin(Lighting shown) => (_from, _left) = (shown, ticks);

    /// <summary>The light that pictures show.</summary>
    /// <param name="target">The light of weather and time of day.</param>
    public Lighting Shown(Lighting target) => _left == 0 ? target : _from!.Towards(target, 1 - ((double)_left / ticks));

    /// <summary>Runs a tick.</summary>
    /// <returns>Whether the light that pictures show has changed.</returns>
    public bool Tick()
    {
        if (_left == 0)
        {
            return false;
        }

        _left--;
        return true;
    }
}
