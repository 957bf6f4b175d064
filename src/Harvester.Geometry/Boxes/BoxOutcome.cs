namespace Harvester.Geometry.Boxes;

/// <summary>Where a cuboid comes to lie for a camera.</summary>
public enum BoxOutcome
{
    /// <summary>Some of it lies in the image.</summary>
    InImage,

    /// <summary>It lies in front of the near plane, but beside the image.</summary>
    OutsideImage,

    /// <summary>All of it lies nearer than the near plane or behind the camera.</summary>
    BehindNearPlane,
}
