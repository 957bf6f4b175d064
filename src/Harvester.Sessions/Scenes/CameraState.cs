using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>The camera with which the game rendered a picture.</summary>
/// <param name="Pose">Position (metres, world) and orientation.</param>
/// <param name="VerticalFovDegrees">Vertical field of view of the window's picture, degrees.</param>
/// <param name="NearClip">Distance of the near plane, metres.</param>
/// <param name="WindowAspect">Width divided by height of the window's picture, as the game reports it.</param>
public sealed record CameraState(Pose Pose, double VerticalFovDegrees, double NearClip, double WindowAspect);
