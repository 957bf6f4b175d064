namespace Harvester.Sessions.Labels;

/// <summary>The rays used for the labels of a frame, by purpose.</summary>
/// <param name="Map">For the pixel map; 0 without one.</param>
/// <param name="Occlusion">For the visibility of objects.</param>
/// <param name="Faces">For the visibility of faces of signs and heads of lights.</param>
/// <param name="IgnoreRegions">For objects beyond the labelling range.</param>
/// <param name="Lanes">For points of lane markings.</param>
/// <param name="Joints">For the visibility of joints.</param>
public sealed record RayCounts(int Map, int Occlusion, int Faces, int IgnoreRegions, int Lanes, int Joints)
{
    /// <summary>For the class map; 0 without one.</summary>
    public int Classes { get; init; }

    /// <summary>For the depth map; 0 without one.</summary>
    public int Depth { get; init; }

    /// <summary>Rays of all phases together.</summary>
    public int Total => Classes + Depth + Map + Occlusion + Faces + IgnoreRegions + Lanes + Joints;
}
