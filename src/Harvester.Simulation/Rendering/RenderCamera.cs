using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The camera of a rendered image.</summary>
/// <param name="Pose">Position and orientation in the world: x right, y forward, z up.</param>
/// <param name="VerticalFovDegrees">Vertical field of view, degrees.</param>
/// <param name="WindowAspect">Width divided by height of the window, whose picture is scaled to the image.</param>
/// <param name="NearClip">Distance of the near plane, metres; what is nearer is not drawn.</param>
/// <param name="Width">Width of the image in pixels.</param>
/// <param name="Height">Height of the image in pixels.</param>
public sealed record RenderCamera(Pose Pose, double VerticalFovDegrees, double WindowAspect, double NearClip, int Width, int Height)
{
    /// <summary>The distortion of the lens.</summary>
    public RenderLens Lens { get; init; } = RenderLens.None;

    internal double FocalX => FocalY * Width / (Height * WindowAspect);

    internal double FocalY => Lens.FocalScale * Height / (2 * Math.Tan(VerticalFovDegrees * Math.PI / 360));

    internal double CentreX => Width * (0.5 + Lens.CentreOffsetX);

    internal double CentreY => Height * (0.5 + Lens.CentreOffsetY);

    /// <summary>
    /// World to clip space, column vectors. After division by w, x and y are pixels (before the lens distorts them), z is near / depth,
    /// which is 1 on the near plane and falls to 0 at infinity, and w is the depth in metres.
    /// </summary>
    internal Matrix4 ViewProjection
    {
        get
        {
            var projection = new Matrix4(new(FocalX, CentreX, 0, 0), new(0, CentreY, -FocalY, 0), new(0, 0, 0, NearClip), new(0, 1, 0, 0));
            return projection * Matrix4.FromWorld(Pose);
        }
    }
}
