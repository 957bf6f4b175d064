using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A node with the game's handle and position.</summary>
/// <param name="Handle">The game's handle: the node's number within its cell times 65536, plus its cell's number, plus 1. 0 is no
/// node.</param>
/// <param name="Position">Metres, world, truncated as the game stores it.</param>
public readonly record struct SurveyedNode(int Handle, Vector3D Position);
