using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;

namespace Harvester.Mod;

/// <summary>The lane lines of the road at the camera, as points to draw.</summary>
internal static class LaneLines
{
    private const int PointsOfALine = 40;

    /// <summary>The points of the lines, both directions', that lie in the image.</summary>
    public static IEnumerable<Projection> Of(RoadNetwork road, Camera camera)
    {
        RoadCurve middle = new RoadCurves(road).Of(0);
        RoadLink link = road.Links[0];
        foreach (double offset in OffsetsOf(link))
        {
            for (int point = 0; point <= PointsOfALine; point++)
            {
                Projection projection = camera.Project(middle.PointBeside((double)point / PointsOfALine, offset));
                if (projection.Outcome == ProjectionOutcome.InImage)
                {
                    yield return projection;
                }
            }
        }
    }

    private static IEnumerable<double> OffsetsOf(RoadLink link)
    {
        for (int marking = 0; link.LanesForward > 0 && marking <= link.LanesForward; marking++)
        {
            yield return RoadGeometry.MarkingOffset(link, marking, RoadGeometry.LaneWidthOf(link));
        }

        // What lies to the right for the others lies to the left for us.
        RoadLink oncoming = link.Reversed();
        for (int marking = 0; oncoming.LanesForward > 0 && marking <= oncoming.LanesForward; marking++)
        {
            yield return -RoadGeometry.MarkingOffset(oncoming, marking, RoadGeometry.LaneWidthOf(oncoming));
        }
    }
}
