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
    /// <summary>For the channels, by <see cref="FrameChannel.RaysKey"/>; those that used none may be missing.</summary>
    public IReadOnlyDictionary<string, int> Channels { get; init; } = new Dictionary<string, int>();

    /// <summary>Rays of all phases together.</summary>
    public int Total => Channels.Values.Sum() + Map + Occlusion + Faces + IgnoreRegions + Lanes + Joints;

    /// <summary>The rays of a channel; 0 if it used none.</summary>
    public int Of(string raysKey) => Channels.TryGetValue(raysKey, out int count) ? count : 0;
}
