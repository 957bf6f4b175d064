using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Runs.Driving;

/// <summary>Places on a road network that no one has chosen: uniform along its roads, from a seed.</summary>
public static class RandomPlaces
{
    private const RoadNodeFlags NotDriven = RoadNodeFlags.Water | RoadNodeFlags.SwitchedOff;

    /// <summary>Draws places on links whose nodes are neither on water nor switched off.</summary>
    /// <exception cref="ArgumentException">There is no such link.</exception>
    public static IReadOnlyList<Vector2D> On(RoadNetwork roads, int count, int seed)
    {
        RoadLink[] links = [.. roads.Links.Where(link => IsDriven(link.From) && IsDriven(link.To))];
        if (links.Length == 0)
        {
            throw new ArgumentException("The road network has no roads for traffic.", nameof(roads));
        }

        double[] ends = new double[links.Length];
        double length = 0;
        for (int i = 0; i < links.Length; i++)
        {
            length += (roads.Nodes[links[i].To].Position - roads.Nodes[links[i].From].Position).Length;
            ends[i] = length;
        }

        Random random = new(seed);
        return [.. Enumerable.Range(0, count).Select(_ => PlaceAt(random.NextDouble() * length))];

        bool IsDriven(int node) => (roads.Nodes[node].Flags & NotDriven) == 0;

        Vector2D PlaceAt(double along)
        {
            int found = Array.BinarySearch(ends, along);
            RoadLink link = links[Math.Min(found >= 0 ? found : ~found, links.Length - 1)];
            Vector3D middle = (roads.Nodes[link.From].Position + roads.Nodes[link.To].Position) * 0.5;
            return new Vector2D(Math.Round(middle.X, 1) + 0.0, Math.Round(middle.Y, 1) + 0.0);
        }
    }
}
