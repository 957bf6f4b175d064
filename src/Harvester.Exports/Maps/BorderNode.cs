using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>A node of a border that may not be there yet.</summary>
/// <param name="Number">Its number in <see cref="LaneBorders.Nodes"/>; null if it has none yet.</param>
/// <param name="Place">Where it is, metres, world.</param>
internal readonly record struct BorderNode(int? Number, Vector3D Place);
