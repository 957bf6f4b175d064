using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>A piece of road as the game tells it.</summary>
/// <param name="Start">Its first node, metres, world.</param>
/// <param name="End">Its last node, metres, world.</param>
/// <param name="LanesForward">Lanes from start to end.</param>
/// <param name="LanesBackward">Lanes from end to start.</param>
/// <param name="MedianWidth">Width of what lies between the directions, metres.</param>
internal readonly record struct ClosestRoad(Vector3D Start, Vector3D End, int LanesForward, int LanesBackward, double MedianWidth);
