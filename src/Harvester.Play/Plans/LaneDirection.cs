using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry;

namespace Harvester.Play.Plans;

/// <summary>The direction of traffic beside a link of the game's roads, where one drives on the right.</summary>
public static class LaneDirection
{
    /// <summary>The heading of the lane at a place, degrees counter-clockwise from north.</summary>
    /// <param name="road">The link.</param>
    /// <param name="place">The place, metres, world.</param>
    public static double HeadingAt(SurveyedRoad road, Vector3D place)
    {
        var along = new Vector2D(road.Second.X - road.First.X, road.Second.Y - road.First.Y);
        var beside = new Vector2D(place.X - road.First.X, place.Y - road.First.Y);
        bool isOneWay = road.LanesToFirst == 0 || road.LanesToSecond == 0;
        bool goesToSecond = isOneWay ? road.LanesToSecond > 0 : along.Cross(beside) <= 0;
        return PathFollower.HeadingOf(goesToSecond ? along : along * -1);
    }
}
