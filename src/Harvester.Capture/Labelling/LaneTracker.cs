using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Tells the lanes around the ego from moment to moment, and remembers the road that it is on.</summary>
/// <param name="roads">What is known of the roads.</param>
/// <param name="idOf">The number by which a vehicle goes in the answers.</param>
public sealed class LaneTracker(IRoads roads, Func<EntityState, int> idOf)
{
    private RoadMatch? _previous;

    /// <summary>The lanes at one moment, and where the roads are from; null when no roads are known there.</summary>
    /// <param name="ego">The car.</param>
    /// <param name="entities">What is around it, at least as far as vehicles are to be found.</param>
    public (LaneObservation Seen, string Source)? Observe(EgoState ego, IReadOnlyList<EntityState> entities)
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
            _previous);
        _previous = seen.Match.HasRoad ? seen.Match : null;
        return (seen, known.Source);
    }

    /// <summary>Whether an entity is a vehicle of the road.</summary>
    public static bool IsVehicle(EntityState entity) =>
        entity?.Class is ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus or ObjectClass.Motorcycle or ObjectClass.Bicycle
            or ObjectClass.Trailer;

    /// <summary>Forgets the road, as when the car has been put elsewhere.</summary>
    public void Forget() => _previous = null;

    private TrafficVehicle[] VehiclesOf(IReadOnlyList<EntityState> entities) =>
    [
        .. entities
            .Where(IsVehicle)
            .Select(entity => new TrafficVehicle(
                idOf(entity),
                entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5),
                Angles.HeadingDegrees(entity.Pose.Axes.Forward),
                entity.ModelMax.Y - entity.ModelMin.Y)),
    ];
}
