using System;
using System.Collections.Generic;
using Harvester.Capture.Labels;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the label of the lanes of one snapshot; remembers the road from frame to frame.</summary>
internal sealed class LaneLabeller(IRoads roads, IRayCaster? rays, ObjectRegistry registry)
{
    /// <summary>Markings are traced this far, metres along the road.</summary>
    private const double MarkingReach = 70;

    private readonly LaneTracker _tracker = new(roads, entity => registry.IdOf(entity));

    /// <summary>Labels the lanes a slice at a time; each element is null until the last, which is the label. No element: no roads are known.</summary>
    public IEnumerable<LanesLabel?> Label(SceneSnapshot snapshot, Camera camera, Func<bool> mayCastRays)
    {
        if (_tracker.Observe(snapshot.Ego, snapshot.Entities) is not { } known)
        {
            yield break;
        }

        yield return null;

        LaneObservation seen = known.Seen;
        var markings = new List<LaneLineView>();
        if (seen is { Status: LaneStatus.Known, Stretch: { } stretch })
        {
            double carOffset = seen.Match.LeftEdge + seen.Match.OffsetFromLeftEdge;
            foreach (LaneLine line in LaneLineTracer.Trace(stretch, carOffset, 0, MarkingReach))
            {
                markings.AddRange(LaneLineProjector.Project(camera, line, snapshot.Ego.Handle, mayCastRays() ? rays : null));
                yield return null;
            }
        }

        yield return LanesLabel.Of(seen, known.Source, markings);
    }

    /// <summary>Passes over a snapshot that is not labelled: the road and the vehicles' numbers are remembered as if it were.</summary>
    public void Pass(SceneSnapshot snapshot) => _tracker.Observe(snapshot.Ego, snapshot.Entities);
}
