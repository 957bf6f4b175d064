namespace Harvester.Exports.Formats.Flow;

/// <summary>What a map of an exported pair holds. All are of the pixels of the first image.</summary>
internal enum FlowMapKind
{
    /// <summary>Flow in KITTI's numbers, of all pixels with a flow.</summary>
    All,

    /// <summary>Flow in KITTI's numbers, of the pixels whose point is also seen in the second image.</summary>
    Visible,

    /// <summary>1 where the surface moved by itself, otherwise 0.</summary>
    Moved,

    /// <summary>Flow as a Middlebury file, of all pixels with a flow.</summary>
    Float,

    /// <summary>255 where the point is also seen in the second image, otherwise 0.</summary>
    VisibleMask,
}
