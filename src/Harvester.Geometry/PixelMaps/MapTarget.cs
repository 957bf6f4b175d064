using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.PixelMaps;

/// <summary>An entity to be shown in a pixel map.</summary>
/// <param name="Entity">Its handle, as rays report it.</param>
/// <param name="Number">Its number in the map; 1 or more, unique.</param>
/// <param name="Cuboid">Its cuboid, which shows where to look for it and how far away it is.</param>
/// <param name="Projection">The cuboid's projection by the map's camera.</param>
public sealed record MapTarget(int Entity, ushort Number, Cuboid Cuboid, CuboidProjection Projection);
