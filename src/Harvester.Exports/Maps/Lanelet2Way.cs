namespace Harvester.Exports.Maps;

/// <summary>A line of a Lanelet2 map.</summary>
/// <param name="Nodes">Its nodes, numbers of <see cref="LaneBorders.Nodes"/>.</param>
/// <param name="Tags">Its tags.</param>
internal sealed record Lanelet2Way(IReadOnlyList<int> Nodes, IReadOnlyList<(string Key, string Value)> Tags);
