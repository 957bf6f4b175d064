namespace Harvester.Capture.Labelling;

/// <summary>The purpose of the rays of a frame.</summary>
internal enum RayPhase
{
    /// <summary>The pixel map.</summary>
    Map,

    /// <summary>The visibility of objects.</summary>
    Occlusion,

    /// <summary>The visibility of faces.</summary>
    Faces,

    /// <summary>Objects beyond the labelling range.</summary>
    IgnoreRegions,

    /// <summary>Points of lane markings.</summary>
    Lanes,

    /// <summary>The visibility of joints.</summary>
    Joints,
}
