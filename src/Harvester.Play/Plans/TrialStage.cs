using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>What trials with scenarios use of the game and of the mod.</summary>
/// <param name="Stage">The actors.</param>
/// <param name="Roads">The roads around a place, metres, world; null while they are not known.</param>
/// <param name="LaneWidth">Width of the lanes of an ordinary road, metres.</param>
/// <param name="NarrowLaneWidth">Width of the lanes of a narrow road, metres.</param>
public sealed record TrialStage(ITrialStage Stage, Func<Vector3D, KnownRoads?> Roads, double LaneWidth, double NarrowLaneWidth)
{
    /// <summary>How far around a place the lanes are known, metres: farther than actors drive.</summary>
    private const double Reach = 420;

    /// <summary>The lanes around a place; takes up to a second, so that it is called on another thread.</summary>
    /// <param name="roads">The roads.</param>
    /// <param name="near">The place, metres, world.</param>
    public LaneNetwork LanesAround(KnownRoads roads, Vector2D near)
    {
        RoadNetwork whole = (roads ?? throw new ArgumentNullException(nameof(roads))).Maps.Value.Network;
        RoadNetwork part = RoadsAround.Of(whole, new Box2D(near.X - Reach, near.Y - Reach, near.X + Reach, near.Y + Reach));
        return LaneNetwork.Of(new RoadCurves(part), new LaneModel(part, LaneWidth, NarrowLaneWidth), MapContent.None);
    }
}
