using Harvester.Geometry;

namespace Harvester.Runs.Sheets;

/// <summary>A place of a contact sheet.</summary>
/// <param name="Name">What the caption says; empty for a place without a name.</param>
/// <param name="Position">World, metres; null for the middle of the road network.</param>
public sealed record SheetPlace(string Name, Vector2D? Position);
