using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the label of the lanes of one snapshot; remembers the road from frame to frame.</summary>
internal sealed class LaneLabeller(IRoads roads, IRayCaster rays, ObjectRegistry registry)
{
    /// <summary>Markings are traced this far, metres along the road.</summary>
    private const double MarkingReach = 70;

    private RoadMatch? _previous;

    /// <summary>Labels the lanes a slice at a time; each element is null until the last, which is the label. No element: no roads are known.</summary>
    public IEnumerable<LanesLabel?> Label(SceneSnapshot snapshot, Camera camera, Func<bool> mayCastRays)
    {
        EgoState ego = snapshot.Ego;
        Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
        if (roads.Near(centre) is not { } known)
        {
            _previous = null;
            yield break;
        }

        LaneObservation seen = known.Lanes.Observe(
            centre,
            Angles.HeadingDegrees(ego.Pose.Axes.Forward),
            ego.Velocity.Length,
            ego.ModelMax.Y - ego.ModelMin.Y,
            VehiclesOf(snapshot),
            _previous);
        _previous = seen.Match.HasRoad ? seen.Match : null;
        yield return null;

        var markings = new List<LaneLineView>();
        if (seen is { Status: LaneStatus.Known, Stretch: { } stretch })
        {
            double carOffset = seen.Match.LeftEdge + seen.Match.OffsetFromLeftEdge;
            foreach (LaneLine line in LaneLineTracer.Trace(stretch, carOffset, 0, MarkingReach))
            {
                markings.AddRange(LaneLineProjector.Project(camera, line, ego.Handle, mayCastRays() ? rays : null));
                yield return null;
            }
        }

        yield return LanesLabel.Of(seen, known.Source, markings);
    }

    private TrafficVehicle[] VehiclesOf(SceneSnapshot snapshot) =>
    [
        .. snapshot.Entities
            .Where(static entity => entity.Class is ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus or ObjectClass.Motorcycle
                or ObjectClass.Bicycle or ObjectClass.Trailer)
            .Select(entity => new TrafficVehicle(
                registry.IdOf(entity),
                entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5),
                Angles.HeadingDegrees(entity.Pose.Axes.Forward),
                entity.ModelMax.Y - entity.ModelMin.Y)),
    ];
}
