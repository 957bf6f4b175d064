namespace Harvester.Capture.Ports;

/// <summary>What could not be read of a game as it should be.</summary>
/// <param name="Vehicles">Where vehicles were listed from.</param>
/// <param name="Peds">Where people were listed from.</param>
/// <param name="Props">Where objects were listed from.</param>
/// <param name="DistortedEntities">Entities that were left out because their matrix is sheared or mirrored.</param>
public sealed record ReadingReport(ListSource Vehicles, ListSource Peds, ListSource Props, int DistortedEntities);
