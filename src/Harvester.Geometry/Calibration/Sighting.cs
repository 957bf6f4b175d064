namespace Harvester.Geometry.Calibration;

/// <summary>A point of the world and where an image shows it.</summary>
/// <param name="CameraPose">The camera's pose, as the game reported it.</param>
/// <param name="World">The point, metres, world.</param>
/// <param name="Pixel">Where it is seen, continuous pixels.</param>
public readonly record struct Sighting(Pose CameraPose, Vector3D World, Vector2D Pixel);
