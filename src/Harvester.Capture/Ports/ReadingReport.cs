namespace Harvester.Capture.Ports;

/// <summary>What could not be read of a game correctly.</summary>
/// <param name="Vehicles">Source of the list of vehicles.</param>
/// <param name="Peds">Source of the list of people.</param>
/// <param name="Props">Source of the list of objects.</param>
/// <param name="DistortedEntities">Number of entities left out because their matrix is sheared or mirrored.</param>
public sealed record ReadingReport(ListSource Vehicles, ListSource Peds, ListSource Props, int DistortedEntities);
