using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A node as the game names and places it.</summary>
/// <param name="Handle">The game's number of it: its number within its cell times 65536, plus its cell's number, plus 1. 0 is no
/// node.</param>
/// <param name="Position">Metres, world, truncated as the game stores it.</param>
public readonly record struct SurveyedNode(int Handle, Vector3D Position);
