namespace Harvester.Play.Features;

/// <summary>A colour for drawing.</summary>
/// <param name="Red">0 to 255.</param>
/// <param name="Green">0 to 255.</param>
/// <param name="Blue">0 to 255.</param>
public readonly record struct Colour(int Red, int Green, int Blue);
