namespace Harvester.Geometry.Visibility;

/// <summary>Whether anything of an object is seen in an image.</summary>
public enum Sight
{
    /// <summary>No ray was cast to find out.</summary>
    NotAsked,

    /// <summary>A ray from the camera met the object.</summary>
    Seen,

    /// <summary>Nothing of it shows: other things lie in front of it, or its part of the cuboid is outside the image.</summary>
    Unseen,

    /// <summary>Rays pass through its cuboid and meet nothing of it anywhere, so it is not drawn, or rays do not meet it.</summary>
    Undetermined,
}
