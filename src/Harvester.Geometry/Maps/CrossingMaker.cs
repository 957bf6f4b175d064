using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// Makes the pedestrian crossings of a map: the painted ones, and along links between two nodes that the road data marks as the ends of a
/// crossing, where none was seen.
/// </summary>
internal static class CrossingMaker
{
    private const RoadNodeFlags Ends =
        RoadNodeFlags.PedestrianCrossing | RoadNodeFlags.PedestrianCrossingWithoutWait | RoadNodeFlags.PedestrianAssisted;

    /// <summary>Width of a crossing whose outline is not known, metres.</summary>
    private const double Width = 3;

    /// <summary>A painted crossing this near to the middle of a link is the link's, metres.</summary>
    private const double SameCrossing = 6;

    /// <summary>The links along which the road data has crossings, ascending.</summary>
    public static IEnumerable<int> LinksOf(RoadNetwork network) =>
        Enumerable
            .Range(0, network.Links.Count)
            .Where(link =>
                (network.Nodes[network.Links[link].From].Flags & Ends) != 0 && (network.Nodes[network.Links[link].To].Flags & Ends) != 0
            );

    /// <summary>Makes the crossings.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="links">Some of <see cref="LinksOf"/>.</param>
    /// <param name="marks">What is painted.</param>
    public static List<MapCrossing> Make(
        RoadNetwork network,
        IEnumerable<int> links,
        IEnumerable<(PaintedMark Mark, MapSource Source)> marks
    )
    {
        List<MapCrossing> crossings =
        [
            .. marks.Where(static mark => mark.Mark.Kind == MarkKind.Crossing).Select(static mark => Of(mark.Mark.Corners, mark.Source)),
        ];
        var painted = new GroundGrid<Vector3D>(SameCrossing);
        foreach (Vector3D place in crossings.Select(static crossing => MiddleOf(crossing.Corners)))
        {
            painted.Add(place, new Box2D(place.X, place.Y, place.X, place.Y));
        }

        foreach (RoadLink link in links.Select(link => network.Links[link]))
        {
            (RoadNode from, RoadNode to) = (network.Nodes[link.From], network.Nodes[link.To]);
            var along = new Vector2D(to.Position.X - from.Position.X, to.Position.Y - from.Position.Y);
            if (along.Length <= 0)
            {
                continue;
            }

            Vector3D middle = (from.Position + to.Position) * 0.5;
            if (!painted.Near(middle.X, middle.Y, SameCrossing).Any(place => (place - middle).Length <= SameCrossing))
            {
                double half = Width / 2 / along.Length;
                var right = new Vector3D(along.Y * half, -along.X * half, 0);
                crossings.Add(
                    Of([from.Position + right, to.Position + right, to.Position - right, from.Position - right], MapSource.Derived)
                );
            }
        }

        return [.. crossings.GroupBy(static crossing => crossing.Id).Select(static same => same.First())];
    }

    private static MapCrossing Of(IReadOnlyList<Vector3D> corners, MapSource source) =>
        new(MapNames.Place("crossing", MiddleOf(corners)), corners, source);

    private static Vector3D MiddleOf(IReadOnlyList<Vector3D> corners) =>
        corners.Aggregate(static (sum, corner) => sum + corner) * (1.0 / corners.Count);
}
