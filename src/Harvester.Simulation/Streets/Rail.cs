namespace Harvester.Simulation.Streets;

/// <summary>One edge of a strip along a road.</summary>
/// <param name="RightOffset">Metres to the right of the road's line.</param>
/// <param name="Height">Metres above it.</param>
internal readonly record struct Rail(double RightOffset, double Height);
