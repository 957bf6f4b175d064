namespace Harvester.Capture.Ports;

/// <summary>Draws a card of known colours over the picture, to see whether grabbed pictures have the right values.</summary>
public interface IColourCard
{
    /// <summary>Shows these patches and no others, in every picture from the next tick on.</summary>
    void Show(IReadOnlyList<ColourPatch> patches);

    /// <summary>Removes all patches. Calling it again has no effect.</summary>
    void Clear();
}
