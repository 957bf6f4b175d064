using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The rays of one frame, counted by their purpose and limited by a budget. Callers check the budget before they cast. Samples of objects
/// are centres of pixels, so that rays for objects that overlap in the image coincide: each is cast once.
/// </summary>
/// <param name="rays">The ray caster.</param>
/// <param name="budget">Maximum number of rays per frame.</param>
internal sealed class FrameRays(IRayCaster rays, int budget) : IRayCaster
{
    private readonly SeenRays _seen = new();
    private readonly int[] _counts = new int[1 + (int)RayPhase.Joints];
    private readonly Dictionary<string, int> _channels = [];
    private RayPhase _phase;
    private string? _channel;
    private int _cast;

    /// <summary>Remembers what the rays of the frame hit, if they report normals; null to remember nothing.</summary>
    public RayRecord? Record { get; init; }

    /// <summary>Number of rays left for the frame.</summary>
    public int Left => budget - _cast;

    /// <summary>The rays of the frame so far, by purpose.</summary>
    public RayCounts Counts =>
        new(
            _counts[(int)RayPhase.Map],
            _counts[(int)RayPhase.Occlusion],
            _counts[(int)RayPhase.Faces],
            _counts[(int)RayPhase.IgnoreRegions],
            _counts[(int)RayPhase.Lanes],
            _counts[(int)RayPhase.Joints]
        )
        {
            Channels = new Dictionary<string, int>(_channels),
        };

    /// <summary>Begins a frame.</summary>
    public void Begin()
    {
        Array.Clear(_counts, 0, _counts.Length);
        _channels.Clear();
        _cast = 0;
        _seen.Clear();
        Record?.Clear();
    }

    /// <summary>Sets the purpose of the following rays.</summary>
    public void Begin(RayPhase phase) => (_phase, _channel) = (phase, null);

    /// <summary>The following rays are those of a channel.</summary>
    public void Begin(string channel) => _channel = channel;

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => Cast(ray, maxDistance, ignoredEntity, out _);

    /// <summary>Casts a ray that also reports the normal of the surface; zero if the game does not, or nothing is recorded.</summary>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        bool isSample = Record is null && _channel is null && _phase is (RayPhase.Occlusion or RayPhase.Faces or RayPhase.IgnoreRegions);
        if (isSample && _seen.TryAnswer(ray, maxDistance, ignoredEntity, out RayHit? known))
        {
            normal = Vector3D.Zero;
            return known;
        }

        RayHit? hit = CastInGame(ray, maxDistance, ignoredEntity, out normal);
        if (isSample)
        {
            _seen.Add(ray, maxDistance, ignoredEntity, hit);
        }

        return hit;
    }

    private RayHit? CastInGame(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        Count();
        _cast++;
        normal = Vector3D.Zero;
        if (Record is null || rays is not ISurfaceRays surfaces)
        {
            return rays.Cast(ray, maxDistance, ignoredEntity);
        }

        RayHit? hit = surfaces.Cast(ray, maxDistance, ignoredEntity, out normal);
        if (hit is { } met)
        {
            Record.Add(new RecordedHit(ray, met.Distance, normal, met.Entity));
        }

        return hit;
    }

    private void Count()
    {
        if (_channel is null)
        {
            _counts[(int)_phase]++;
        }
        else
        {
            _channels[_channel] = (_channels.TryGetValue(_channel, out int count) ? count : 0) + 1;
        }
    }
}
