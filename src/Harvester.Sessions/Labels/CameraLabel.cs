using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>The camera of a saved image. Formulas and frames: docs/conventions.md.</summary>
/// <param name="Pose">Position (metres, world) and axes.</param>
/// <param name="VerticalFovDegrees">Vertical field of view of the window's picture before the lens, degrees.</param>
/// <param name="Width">Width of the saved image, pixels.</param>
/// <param name="Height">Height of the saved image, pixels.</param>
/// <param name="WindowAspect">Width divided by height of the window's picture.</param>
/// <param name="NearClip">Distance of the near plane, metres.</param>
/// <param name="Fx">Horizontal focal length of the saved image, focal scale included, pixels.</param>
/// <param name="Fy">Vertical focal length of the saved image, focal scale included, pixels.</param>
/// <param name="Cx">Principal point from the left edge, pixels.</param>
/// <param name="Cy">Principal point from the upper edge, pixels.</param>
/// <param name="Distortion">Radial distortion.</param>
public sealed record CameraLabel(
    Pose Pose,
    double VerticalFovDegrees,
    int Width,
    int Height,
    double WindowAspect,
    double NearClip,
    double Fx,
    double Fy,
    double Cx,
    double Cy,
    DistortionLabel Distortion);
