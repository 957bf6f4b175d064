namespace Harvester.Simulation.Streets;

/// <summary>How roads are painted.</summary>
/// <param name="IsVaried">Whether lane widths and paint are drawn at random for each road.</param>
/// <param name="Wear">How worn the paint is, from 0, new, to 1.</param>
internal readonly record struct RoadStyle(bool IsVaried, double Wear);
