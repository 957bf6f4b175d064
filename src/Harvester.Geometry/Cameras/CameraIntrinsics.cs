namespace Harvester.Geometry.Cameras;

/// <summary>
/// How a camera maps directions to pixels of the saved image. The vertical field of view and the aspect ratio belong to the game's window;
/// the window's picture is then scaled to the saved image, so that fy = s · H / (2 tan(F/2)) and fx = s · W / (2 tan(F/2) · aspect), with
/// W, H of the saved image, F the vertical field of view, and s the lens's focal scale.
/// </summary>
public sealed record CameraIntrinsics
{
    /// <summary>Creates the intrinsics of a saved image.</summary>
    /// <param name="verticalFovDegrees">Vertical field of view of the window's picture, degrees, between 0 and 180 exclusive.</param>
    /// <param name="image">Size of the saved image, pixels.</param>
    /// <param name="windowAspect">Width divided by height of the window's picture, as the game reports it; greater than 0.</param>
    /// <param name="nearClip">Distance of the near plane, metres; greater than 0.</param>
    /// <param name="lens">How the picture deviates from a pinhole camera's; <see cref="Cameras.Lens.Ideal"/> if nothing is known.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is outside its range or not finite.</exception>
    public CameraIntrinsics(double verticalFovDegrees, ImageSize image, double windowAspect, double nearClip, Lens lens)
    {
        VerticalFovDegrees = Guard.InOpenRange(verticalFovDegrees, 0, 180, nameof(verticalFovDegrees));
        WindowAspect = Guard.Positive(windowAspect, nameof(windowAspect));
        NearClip = Guard.Positive(nearClip, nameof(nearClip));
        Guard.Positive(lens.FocalScale, nameof(lens));
        Guard.Positive(image.Width, nameof(image));
        Image = image;
        Lens = lens;
        double tangent = Math.Tan(Angles.ToRadians(verticalFovDegrees) / 2);
        Fx = Guard.Positive(lens.FocalScale * image.Width / (2 * tangent * windowAspect), nameof(windowAspect));
        Fy = Guard.Positive(lens.FocalScale * image.Height / (2 * tangent), nameof(verticalFovDegrees));
        Cx = image.Width * (0.5 + lens.CentreOffsetX);
        Cy = image.Height * (0.5 + lens.CentreOffsetY);
    }

    /// <summary>Vertical field of view of the window's picture without the lens, degrees.</summary>
    public double VerticalFovDegrees { get; }

    /// <summary>Size of the saved image, pixels.</summary>
    public ImageSize Image { get; }

    /// <summary>Width divided by height of the window's picture.</summary>
    public double WindowAspect { get; }

    /// <summary>Distance of the near plane, metres.</summary>
    public double NearClip { get; }

    /// <summary>Focal scale, principal point shift and radial distortion.</summary>
    public Lens Lens { get; }

    /// <summary>Horizontal focal length, pixels.</summary>
    public double Fx { get; }

    /// <summary>Vertical focal length, pixels.</summary>
    public double Fy { get; }

    /// <summary>Principal point, pixels from the left edge.</summary>
    public double Cx { get; }

    /// <summary>Principal point, pixels from the upper edge.</summary>
    public double Cy { get; }
}
