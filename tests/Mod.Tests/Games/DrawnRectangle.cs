using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod.Tests.Games;

/// <summary>A rectangle over the picture.</summary>
/// <param name="Place">Fractions of the window.</param>
/// <param name="Colour">What it is filled with.</param>
internal sealed record DrawnRectangle(Box2D Place, Colour Colour);
