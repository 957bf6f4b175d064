namespace Harvester.Geometry.Boxes;

/// <summary>Where a cuboid lies for a camera.</summary>
public enum BoxOutcome
{
    /// <summary>At least part of it is in the image.</summary>
    InImage,

    /// <summary>It is in front of the near plane, but outside the image.</summary>
    OutsideImage,

    /// <summary>All of it is nearer than the near plane or behind the camera.</summary>
    BehindNearPlane,
}
