namespace Harvester.Capture.Labelling;

/// <summary>What the rays of a frame have hit, for its depth map.</summary>
internal sealed class RayRecord
{
    private readonly List<RecordedHit> _hits = [];

    /// <summary>The hits, in the order of their rays.</summary>
    public IReadOnlyList<RecordedHit> Hits => _hits;

    /// <summary>Begins a frame.</summary>
    public void Clear() => _hits.Clear();

    /// <summary>Adds a hit.</summary>
    public void Add(RecordedHit hit) => _hits.Add(hit);
}
