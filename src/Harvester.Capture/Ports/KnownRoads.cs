using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;

namespace Harvester.Capture.Ports;

/// <summary>Roads on which lanes can be found.</summary>
/// <param name="Lanes">Finds the lanes around a car on them.</param>
/// <param name="Maps">The lanes by name around any place; prepared when first asked for, which takes a moment for a large network.</param>
/// <param name="Source">Their source, as a short camelCase word for the labels: roadFile, game, simulation.</param>
public sealed record KnownRoads(LaneObserver Lanes, Lazy<LaneMaps> Maps, string Source);
