using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Finds the lanes around the ego from frame to frame, and keeps the road that it is on.</summary>
/// <param name="roads">The known roads.</param>
/// <param name="idOf">Gives the id of a vehicle in the results.</param>
public sealed class LaneTracker(IRoads roads, Func<EntityState, int> idOf)
{
    private RoadMatch? _previous;

    /// <summary>The lanes at one moment, and the roads; null if no roads are known there.</summary>
    /// <param name="ego">The car.</param>
    /// <param name="entities">The entities around it, at least up to the range of vehicles.</param>
    public (LaneObservation Seen, KnownRoads Roads)? Observe(EgoState ego, IReadOnlyList<EntityState> entities)
    {
        if (ego is null)
        {
            throw new ArgumentNullException(nameof(ego));
        }

        Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
        if (roads.Near(centre) is not { } known)
        {
            _previous = null;
            return null;
        }

        LaneObservation seen = known.Lanes.Observe(
            centre,
            Angles.HeadingDegrees(ego.Pose.Axes.Forward),
            ego.Velocity.Length,
            ego.ModelMax.Y - ego.ModelMin.Y,
            VehiclesOf(entities),
            _previous
        );
        _previous = seen.Match.HasRoad ? seen.Match : null;
        return (seen, known);
    }

    /// <summary>Discards the road, as when the car has been moved to another place.</summary>
    public void Reset() => _previous = null;

    private TrafficVehicle[] VehiclesOf(IReadOnlyList<EntityState> entities) =>
        [
            .. entities
                .Where(static entity => VehicleClasses.AreVehicles(entity.Class))
                .Select(entity => new TrafficVehicle(
                    idOf(entity),
                    entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5),
                    Angles.HeadingDegrees(entity.Pose.Axes.Forward),
                    entity.ModelMax.Y - entity.ModelMin.Y
                )),
        ];
}
