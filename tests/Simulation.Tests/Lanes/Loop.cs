using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>
/// A closed road without junctions: two straights of 300 m joined by half circles of 80 m radius, one straight with an S-bend in it.
/// </summary>
internal static class Loop
{
    private const double Spacing = 5;
    private const double Straight = 300;
    private const double Radius = 80;

    public static RoadNetwork Network(int lanes = 2)
    {
        Vector3D[] points = [.. Points()];
        RoadNode[] nodes = [.. points.Select((point, i) => new RoadNode(0, i, point, string.Empty, RoadNodeFlags.None))];
        RoadLink[] links = [.. points.Select((_, i) => new RoadLink(i, (i + 1) % points.Length, lanes, lanes, null, RoadLinkFlags.None))];
        return new RoadNetwork(nodes, links);
    }

    private static IEnumerable<Vector3D> Points()
    {
        int along = (int)(Straight / Spacing);
        int around = (int)(Math.PI * Radius / Spacing);
        for (int i = 0; i < along; i++)
        {
            // A cosine bell: 10 m to the side and back, with bends of some 450 m radius at the sharpest.
            double y = i * Spacing;
            yield return new Vector3D(Radius + (5 * (1 - Math.Cos(2 * Math.PI * y / Straight))), y, 0);
        }

        for (int i = 0; i < around; i++)
        {
            double angle = Math.PI * i / around;
            yield return new Vector3D(Radius * Math.Cos(angle), Straight + (Radius * Math.Sin(angle)), 0);
        }

        for (int i = 0; i < along; i++)
        {
            yield return new Vector3D(-Radius, Straight - (i * Spacing), 0);
        }

        for (int i = 0; i < around; i++)
        {
            double angle = Math.PI * (1 + ((double)i / around));
            yield return new Vector3D(Radius * Math.Cos(angle), Radius * Math.Sin(angle), 0);
        }
    }
}
