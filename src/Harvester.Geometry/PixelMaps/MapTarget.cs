using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.PixelMaps;

/// <summary>An entity that a pixel map is to show.</summary>
/// <param name="Entity">Its handle, as rays report it.</param>
/// <param name="Number">Its number in the map; 1 or more, one entity each.</param>
/// <param name="Cuboid">Its cuboid, which tells where to look for it and how far it is.</param>
/// <param name="Projection">The cuboid's image by the map's camera.</param>
public sealed record MapTarget(int Entity, ushort Number, Cuboid Cuboid, CuboidProjection Projection);
