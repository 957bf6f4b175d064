using Harvester.Geometry.Lanes;

namespace Harvester.Capture.Ports;

/// <summary>Roads that lanes can be told on.</summary>
/// <param name="Lanes">Tells the lanes around a car on them.</param>
/// <param name="Source">Where they are from, as a short camelCase word for the labels: roadFile, game, simulation.</param>
public sealed record KnownRoads(LaneObserver Lanes, string Source);
