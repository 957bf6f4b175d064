using Harvester.Geometry.Lanes;

namespace Harvester.Capture.Ports;

/// <summary>Roads on which lanes can be found.</summary>
/// <param name="Lanes">Finds the lanes around a car on them.</param>
/// <param name="Source">Their source, as a short camelCase word for the labels: roadFile, game, simulation.</param>
public sealed record KnownRoads(LaneObserver Lanes, string Source);
