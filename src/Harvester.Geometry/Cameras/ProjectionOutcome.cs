namespace Harvester.Geometry.Cameras;

/// <summary>Where a point of the world lies for a camera.</summary>
public enum ProjectionOutcome
{
    /// <summary>In front of the near plane and within the image: 0 ≤ u &lt; width, 0 ≤ v &lt; height.</summary>
    InImage,

    /// <summary>In front of the near plane, outside the image.</summary>
    OutsideImage,

    /// <summary>Nearer than the near plane, or behind the camera: it has no pixel.</summary>
    BehindNearPlane,
}
