using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Ports;

/// <summary>
/// Tells from the drawing itself how much of an entity is hidden. Only a game that can draw an entity alone, as the simulation does, has
/// it. It never throws.
/// </summary>
public interface IDrawnOcclusion
{
    /// <summary>
    /// Of the pixels of an image of the present moment at which each entity would be drawn if it were alone, the fraction that shows
    /// something else.
    /// </summary>
    /// <param name="handles">The entities.</param>
    /// <param name="image">Size of the image, pixels.</param>
    /// <returns>The fractions, 0 to 1, by handle; an entity that has no pixel even alone is absent.</returns>
    IReadOnlyDictionary<int, double> HiddenFractions(IReadOnlyCollection<int> handles, ImageSize image);
}
