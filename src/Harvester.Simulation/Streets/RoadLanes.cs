namespace Harvester.Simulation.Streets;

/// <summary>The lane layout of a town's road.</summary>
/// <param name="Forward">Lanes from its start to its end.</param>
/// <param name="Backward">Lanes from its end to its start.</param>
/// <param name="MedianWidth">Metres between the directions.</param>
/// <param name="IsNarrow">Whether its lanes are narrow.</param>
internal sealed record RoadLanes(int Forward, int Backward, double MedianWidth = 0, bool IsNarrow = false);
