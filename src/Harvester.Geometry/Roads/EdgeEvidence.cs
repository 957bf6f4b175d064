using System;
using System.Collections.Generic;

namespace Harvester.Geometry.Roads;

/// <summary>
/// Tells the width of a link's lanes from points on the edges of the road, if these prove themselves. What the game means by the
/// edge that it gives is not documented, so nothing is taken for granted: the points must lie on both sides of the link, square to it,
/// each side told at least twice, and all must give the same plausible width.
/// </summary>
internal static class EdgeEvidence
{
    /// <summary>Widths lie between these, metres; others come from an edge of something else.</summary>
    private const double MinLaneWidth = 3;
    private const double MaxLaneWidth = 7;

    /// <summary>
    /// Tangent of the angle, 11 degrees, by which a point may miss the square to its link: camber, and the start of a bend.
    /// </summary>
    private const double MaxSlant = 0.2;

    /// <summary>By how much widths of one link may differ, metres: more would show in labels.</summary>
    private const double MaxDisagreement = 0.2;

    /// <summary>How often each side has to be told.</summary>
    private const int MinAnswers = 2;

    /// <summary>The width of a link's lanes, metres; null when the points do not prove one.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="link">The link.</param>
    /// <param name="edges">What was told of its edges; a single point that cannot be one throws doubt on all.</param>
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
        double least = double.PositiveInfinity, most = double.NegativeInfinity;
        int onRight = 0, onLeft = 0;
        foreach (RoadEdge edge in edges)
        {
            Vector3D apart = edge.Point - (edge.IsAtStart ? start : end);
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

        bool isProven = onRight >= MinAnswers && onLeft >= MinAnswers
            && least > MinLaneWidth && most < MaxLaneWidth && most - least <= MaxDisagreement;
        return isProven ? (least + most) / 2 : null;
    }

    /// <summary>
    /// The width by the rule of <see cref="RoadGeometry"/> when an edge lies at an offset; infinite on a side without lanes.
    /// </summary>
    private static double LaneWidth(RoadLink link, double offset) => link.IsOneWay
        ? 2 * Math.Abs(offset) / (link.LanesForward + link.LanesBackward)
        : (Math.Abs(offset) - ((link.MedianWidth ?? 0) / 2)) / (offset > 0 ? link.LanesForward : link.LanesBackward);
}
