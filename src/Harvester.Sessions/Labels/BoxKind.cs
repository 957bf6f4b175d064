namespace Harvester.Sessions.Labels;

/// <summary>What a 2D box of a label encloses.</summary>
public enum BoxKind
{
    /// <summary><see cref="ObjectLabel.Box2D"/>: the part of the cuboid's silhouette inside the image.</summary>
    Cuboid,

    /// <summary><see cref="ObjectLabel.Box2DAmodal"/>: the whole of the cuboid's silhouette, inside and outside the image.</summary>
    Amodal,

    /// <summary><see cref="ObjectLabel.Box2DVisible"/>: the visible pixels of the object.</summary>
    Visible,

    /// <summary><see cref="ObjectLabel.Box2DWhole"/>: all pixels of the object in the image, hidden ones included.</summary>
    Whole,
}
