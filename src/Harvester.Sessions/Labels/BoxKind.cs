namespace Harvester.Sessions.Labels;

/// <summary>What a 2D box of a label is drawn around.</summary>
public enum BoxKind
{
    /// <summary><see cref="ObjectLabel.Box2D"/>: the part of the cuboid's silhouette in the image.</summary>
    Cuboid,

    /// <summary><see cref="ObjectLabel.Box2DAmodal"/>: the whole of the cuboid's silhouette, in the image or not.</summary>
    Amodal,

    /// <summary><see cref="ObjectLabel.Box2DVisible"/>: the pixels at which the object is seen.</summary>
    Visible,
}
