using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A rectangle of one colour over the game's picture.</summary>
/// <param name="Place">Its place, fractions of the window.</param>
/// <param name="Red">0 to 255.</param>
/// <param name="Green">0 to 255.</param>
/// <param name="Blue">0 to 255.</param>
public readonly record struct ColourPatch(Box2D Place, byte Red, byte Green, byte Blue);
