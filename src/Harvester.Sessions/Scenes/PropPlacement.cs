using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>A prop placed in the game's world.</summary>
/// <param name="Name">Name of its model.</param>
/// <param name="Position">Metres, world.</param>
/// <param name="Rotation">Its orientation in the world.</param>
public sealed record PropPlacement(string Name, Vector3D Position, EulerAngles Rotation);
