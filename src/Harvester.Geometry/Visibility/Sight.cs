namespace Harvester.Geometry.Visibility;

/// <summary>Whether any of an object is visible in an image.</summary>
public enum Sight
{
    /// <summary>No ray was cast to find out.</summary>
    NotAsked,

    /// <summary>A ray from the camera hit the object.</summary>
    Seen,

    /// <summary>Nothing of it is visible: other things lie in front of it, or its part of the cuboid is outside the image.</summary>
    Unseen,

    /// <summary>Rays pass through its cuboid without hitting it, so it is not drawn, or rays do not hit it.</summary>
    Undetermined,
}
