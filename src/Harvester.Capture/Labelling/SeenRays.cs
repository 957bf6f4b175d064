using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>What rays of a still world have hit, by ray, so that none is cast twice.</summary>
internal sealed class SeenRays
{
    private readonly Dictionary<(Ray Ray, int Ignored), (double MaxDistance, RayHit? Hit)> _answers = [];

    /// <summary>Begins another moment of the world.</summary>
    public void Clear() => _answers.Clear();

    /// <summary>Adds a ray that was cast.</summary>
    public void Add(Ray ray, double maxDistance, int ignoredEntity, RayHit? hit) => _answers[(ray, ignoredEntity)] = (maxDistance, hit);

    /// <summary>
    /// Answers a ray from one that was cast before. A hit at distance d answers every length: the hit if it is d or more, otherwise none. A
    /// ray that hit nothing answers lengths up to its own.
    /// </summary>
    /// <returns>False if it must be cast.</returns>
    public bool TryAnswer(Ray ray, double maxDistance, int ignoredEntity, out RayHit? hit)
    {
        hit = null;
        if (!_answers.TryGetValue((ray, ignoredEntity), out (double MaxDistance, RayHit? Hit) answer))
        {
            return false;
        }

        if (answer.Hit is { } met)
        {
            hit = maxDistance >= met.Distance ? met : null;
            return true;
        }

        return maxDistance <= answer.MaxDistance;
    }
}
