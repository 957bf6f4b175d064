using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.World;

/// <summary>
/// A cache of recent sites. A program that runs several games usually uses the same roads, and a site takes far longer to build than what
/// moves on it.
/// </summary>
internal sealed class SiteCache
{
    /// <summary>Maximum number of cached sites; a town takes some 30 MB.</summary>
    private const int MaxKept = 3;

    private readonly Lock _guard = new();
    private readonly List<(object Key, Lazy<Site> Site)> _kept = [];

    /// <summary>The cache of the program's worlds.</summary>
    public static SiteCache Shared { get; } = new();

    /// <summary>A town generated from a seed.</summary>
    public Site Town(int seed, RoadStyle style = default) => Of((seed, style), () => Site.OfTown(seed, style));

    /// <summary>The part of given roads within a radius of a point.</summary>
    /// <exception cref="ArgumentException">No road lies there.</exception>
    public Site Roads(int seed, RoadNetwork network, Vector3D centre, double radiusMetres, RoadStyle style = default) =>
        Of((seed, network, centre, radiusMetres, style), () => Site.OfRoads(seed, network, centre, radiusMetres, style));

    private Site Of(object key, Func<Site> build)
    {
        Lazy<Site> site;
        lock (_guard)
        {
            int index = _kept.FindIndex(entry => entry.Key.Equals(key));
            site = index >= 0 ? _kept[index].Site : new Lazy<Site>(build);
            if (index >= 0 || _kept.Count == MaxKept)
            {
                _kept.RemoveAt(Math.Max(0, index));
            }

            _kept.Add((key, site));
        }

        // Built outside the lock: only callers that want the same site wait for it.
        return site.Value;
    }
}
