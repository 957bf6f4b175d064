using Harvester.Geometry;
using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Labels;

/// <summary>The camera of a saved image. Formulas and frames: docs/conventions.md.</summary>
/// <param name="Pose">Position (metres, world) and axes.</param>
/// <param name="VerticalFovDegrees">Vertical field of view of the window's picture without the lens, degrees.</param>
/// <param name="Width">Width of the saved image, pixels.</param>
/// <param name="Height">Height of the saved image, pixels.</param>
/// <param name="WindowAspect">Width divided by height of the window's picture.</param>
/// <param name="NearClip">Distance of the near plane, metres.</param>
/// <param name="Fx">Horizontal focal length of the saved image, focal scale included, pixels.</param>
/// <param name="Fy">Vertical focal length of the saved image, focal scale included, pixels.</param>
/// <param name="Cx">Principal point from the left edge, pixels.</param>
/// <param name="Cy">Principal point from the upper edge, pixels.</param>
/// <param name="Distortion">Focal scale and coefficients of the radial distortion.</param>
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
    DistortionLabel Distortion
)
{
    /// <summary>Creates the label of a camera.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="camera"/> is null.</exception>
    public static CameraLabel Of(Camera camera)
    {
        CameraIntrinsics intrinsics = (camera ?? throw new ArgumentNullException(nameof(camera))).Intrinsics;
        return new CameraLabel(
            camera.Pose,
            intrinsics.VerticalFovDegrees,
            intrinsics.Image.Width,
            intrinsics.Image.Height,
            intrinsics.WindowAspect,
            intrinsics.NearClip,
            intrinsics.Fx,
            intrinsics.Fy,
            intrinsics.Cx,
            intrinsics.Cy,
            new DistortionLabel(intrinsics.Lens.FocalScale, intrinsics.Lens.K1, intrinsics.Lens.K2)
        );
    }

    /// <summary>
    /// Creates the camera that the label describes. The label does not store the shift of the principal point, which follows from cx and
    /// cy.
    /// </summary>
    /// <exception cref="ArgumentException">A value is outside its range.</exception>
    public Camera ToCamera()
    {
        var lens = new Lens(Distortion.FocalScale, (Cx / Width) - 0.5, (Cy / Height) - 0.5, Distortion.K1, Distortion.K2);
        return new Camera(Pose, new CameraIntrinsics(VerticalFovDegrees, new ImageSize(Width, Height), WindowAspect, NearClip, lens));
    }
}
