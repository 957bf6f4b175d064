using Harvester.Geometry;

namespace Harvester.Simulation.Settings;

/// <summary>What one thing does in a replay.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Size">Width, length and height of its box, metres, by which its model is chosen.</param>
/// <param name="States">Its state at each step; null where it is not there.</param>
public sealed record ReplayTrack(ReplayKind Kind, Vector3D Size, IReadOnlyList<ReplayState?> States);
