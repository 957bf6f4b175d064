using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;

namespace Harvester.Runs.Harvesting;

/// <summary>Chooses places all over a road network, from a seed: each as far as possible from those before it.</summary>
public static class SpreadPlaces
{
    /// <summary>Nodes among which a few places are chosen; more would only take longer.</summary>
    private const int FewestCandidates = 4000;

    /// <summary>For many places there are this many nodes for each, so that those of a large network are not used up early.</summary>
    private const int CandidatesOfPlace = 20;

    /// <summary>Least distance between two places, metres: what one world shows of the roads.</summary>
    private const double Apart = 100;

    /// <summary>Chooses the places.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="count">Number of places.</param>
    /// <param name="seed">Random seed.</param>
    /// <param name="first">The first place; null for a random one.</param>
    /// <exception cref="UsageException">The network has fewer places.</exception>
    public static List<Vector2D> Of(RoadNetwork network, int count, int seed, Vector2D? first = null)
    {
        var random = new Random(seed);
        HashSet<int> ends =
        [
            .. network.Links.Where(link => link.LanesForward + link.LanesBackward > 0).SelectMany(link => new[] { link.From, link.To }),
        ];
        Vector3D[] open =
        [
            .. ends.Order()
                .Where(node => (network.Nodes[node].Flags & RoadNodeFlags.Water) == 0)
                .Select(node => network.Nodes[node].Position),
        ];
        random.Shuffle(open);
        int candidates = Math.Max(FewestCandidates, CandidatesOfPlace * count);
        open = open.Length > candidates ? open[..candidates] : open;
        double[] distances = [.. open.Select(_ => double.PositiveInfinity)];
        var places = new List<Vector2D>();
        if (first is { } start)
        {
            Take(start);
        }

        while (places.Count < count)
        {
            int farthest = open.Length == 0 ? -1 : Array.IndexOf(distances, distances.Max());
            if (farthest < 0 || distances[farthest] < Apart)
            {
                throw new UsageException(
                    $"The road network has only {places.Count} places {Apart} m apart, fewer than the {count} of --places."
                );
            }

            Take(new Vector2D(open[farthest].X, open[farthest].Y));
        }

        return places;

        void Take(Vector2D place)
        {
            places.Add(place);
            for (int i = 0; i < open.Length; i++)
            {
                distances[i] = Math.Min(distances[i], new Vector3D(open[i].X - place.X, open[i].Y - place.Y, 0).Length);
            }
        }
    }
}
