using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// Colours over the picture, for the self-test. The game draws a rectangle for one frame only, so all of them are drawn in each tick.
/// </summary>
/// <param name="display">Draws the rectangles.</param>
public sealed class DrawnCard(IDisplay display) : IColourCard, IFeature
{
    private IReadOnlyList<ColourPatch> _patches = [];

    /// <inheritdoc/>
    public string Name => "The card of colours";

    /// <inheritdoc/>
    public bool IsOn => _patches.Count > 0;

    /// <inheritdoc/>
    public void Show(IReadOnlyList<ColourPatch> patches) => _patches = patches;

    /// <inheritdoc/>
    public void Clear() => _patches = [];

    /// <inheritdoc/>
    public void Tick()
    {
        foreach (ColourPatch patch in _patches)
        {
            display.Rectangle(patch.Place, new Colour(patch.Red, patch.Green, patch.Blue));
        }
    }

    /// <inheritdoc/>
    public void Stop() => Clear();
}
