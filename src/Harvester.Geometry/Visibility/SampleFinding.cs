namespace Harvester.Geometry.Visibility;

/// <summary>What a ray through a sample of an object's silhouette finds.</summary>
internal enum SampleFinding
{
    /// <summary>The object.</summary>
    OnObject,

    /// <summary>Neither the object nor anything in front of its cuboid.</summary>
    Gap,

    /// <summary>Something in front of the object's cuboid.</summary>
    Stopped,

    /// <summary>Something inside the object's cuboid, with the object behind it.</summary>
    HiddenInside,
}
