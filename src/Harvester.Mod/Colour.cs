namespace Harvester.Mod;

/// <summary>A colour of the game's drawing natives, 0 to 255 each.</summary>
internal readonly record struct Colour(int Red, int Green, int Blue, int Alpha);
