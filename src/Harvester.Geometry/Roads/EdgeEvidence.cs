namespace Harvester.Geometry.Roads;

/// <summary>
/// Derives the width of a link's lanes from points on the edges of the road, if these are consistent. What the game means by the edge that
/// it reports is undocumented, so nothing is assumed: the points must lie on both sides of the link, perpendicular to it, each side
/// reported at least twice, and all must give the same plausible width.
/// </summary>
internal static class EdgeEvidence
{
    /// <summary>Minimum plausible width, metres. Widths outside the range come from an edge of something else.</summary>
    private const double MinLaneWidth = 3;
    private const double MaxLaneWidth = 7;

    /// <summary>
    /// Tangent of the maximum deviation of a point from the perpendicular to its link, 11 degrees: camber, and the start of a bend.
    /// </summary>
    private const double MaxSlant = 0.2;

    /// <summary>Maximum difference of the widths of one link, metres: a larger one would show in labels.</summary>
    private const double MaxDisagreement = 0.2;

    /// <summary>Minimum number of points on each side.</summary>
    private const int MinAnswers = 2;

    /// <summary>The width of a link's lanes, metres; null if the points do not establish one.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="link">The link.</param>
    /// <param name="edges">The reported edge points; a single implausible one invalidates all.</param>
    public static double? LaneWidth(RoadNetwork network, RoadLink link, IReadOnlyList<RoadEdge> edges)
    {
        Vector3D start = network.Nodes[link.From].Position;
        Vector3D end = network.Nodes[link.To].Position;
        var along = new Vector3D(end.X - start.X, end.Y - start.Y, 0);
        bool isMedianMissing = link.MedianWidth is null && !link.IsOneWay;
        if (along.Length == 0 || isMedianMissing)
        {
            return null;
        }

        Vector3D right = new Vector3D(along.Y, -along.X, 0) * (1 / along.Length);
        double least = double.PositiveInfinity,
            most = double.NegativeInfinity;
        int onRight = 0,
            onLeft = 0;
        foreach (RoadEdge edge in edges)
        {
            Vector3D apart = edge.Point - (edge.IsAtStart ? start : end);

            // The point's distance across the road, positive to the right; what remains must be small beside it. Written so that a
            // coordinate that is no number fails.
            double offset = apart.Dot(right);
            if (!((apart - (right * offset)).Length <= MaxSlant * Math.Abs(offset)))
            {
                return null;
            }

            double width = LaneWidth(link, offset);
            least = Math.Min(least, width);
            most = Math.Max(most, width);
            onRight += offset > 0 ? 1 : 0;
            onLeft += offset > 0 ? 0 : 1;
        }

        // All points agree on a plausible width, and both sides of the road are proven by several points.
        bool isProven =
            onRight >= MinAnswers && onLeft >= MinAnswers && least > MinLaneWidth && most < MaxLaneWidth && most - least <= MaxDisagreement;
        return isProven ? (least + most) / 2 : null;
    }

    /// <summary>
    /// The width by the rule of <see cref="RoadGeometry"/> if an edge lies at an offset; infinite on a side without lanes.
    /// </summary>
    private static double LaneWidth(RoadLink link, double offset) =>
        link.IsOneWay
            ? 2 * Math.Abs(offset) / (link.LanesForward + link.LanesBackward)
            : (Math.Abs(offset) - ((link.MedianWidth ?? 0) / 2)) / (offset > 0 ? link.LanesForward : link.LanesBackward);
}
