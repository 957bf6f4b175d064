using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Labels the lanes of one snapshot; keeps the road from frame to frame.</summary>
internal sealed class LaneLabeller(IRoads roads, IRoadPaint? paint, FrameRays? rays, ObjectRegistry registry)
{
    /// <summary>Length to which boundaries and markings are traced, metres along the road.</summary>
    private const double LineReach = 70;

    private readonly LaneTracker _tracker = new(roads, entity => registry.IdOf(entity));

    /// <summary>Labels the lanes in steps: those of the frame, of the vehicles that are labelled already, and of lights.</summary>
    /// <param name="draft">The frame; without lanes afterwards if no roads are known.</param>
    /// <param name="mayCastRays">Called before each line; if it returns false, the visibility of its points is unknown.</param>
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        draft.Lanes = null;
        (SceneSnapshot snapshot, Camera camera) = (draft.Snapshot, draft.Camera);
        if (_tracker.Observe(snapshot.Ego, snapshot.Entities) is not { } known)
        {
            yield break;
        }

        yield return WorkStep.Pause;

        LaneObservation seen = known.Seen;
        var boundaries = new List<LaneLineView>();
        List<LaneLineView> markings = [];
        bool isPaintKnown = paint is { IsComplete: true } || seen.WidthSource is LaneWidthSource.Paint or LaneWidthSource.PartlyPaint;
        if (seen is { Status: LaneStatus.Known, Stretch: { } stretch })
        {
            double carOffset = seen.Match.LeftEdge + seen.Match.OffsetFromLeftEdge;
            foreach (LaneLine line in Painted(stretch, carOffset, snapshot.Ego))
            {
                isPaintKnown = true;
                markings.AddRange(Project(line));
                yield return WorkStep.Pause;
            }

            foreach (LaneLine line in LaneLineTracer.Trace(stretch, carOffset, 0, LineReach))
            {
                boundaries.AddRange(Project(line));
                yield return WorkStep.Pause;
            }
        }

        var lanes = LanesLabel.Of(seen, known.Roads.Source, boundaries, isPaintKnown ? markings : null);
        yield return WorkStep.Pause;

        LaneMaps maps = known.Roads.Maps.Value;
        yield return WorkStep.Do(maps.MakeAround(LaneNames.CentreOf(snapshot.Ego)));
        draft.Lanes = LaneNames.Named(lanes, seen, snapshot.Ego, maps);
        yield return WorkStep.Do(LaneNames.NameVehicles(draft, maps));
        yield return WorkStep.Do(LaneNames.NameGoverned(draft, registry.IdsOf(snapshot.Entities), maps));

        IReadOnlyList<LaneLineView> Project(LaneLine line) =>
            LaneLineProjector.Project(
                camera,
                line,
                snapshot.Ego.Handle,
                mayCastRays() && rays?.Left >= LaneLineProjector.MaxRays(line) ? rays : null
            );
    }

    /// <summary>Passes over a snapshot that is not labelled; the road and the ids of vehicles are updated all the same.</summary>
    public void Pass(SceneSnapshot snapshot) => _tracker.Observe(snapshot.Ego, snapshot.Entities);

    private IReadOnlyList<LaneLine> Painted(RoadStretch stretch, double carOffset, EgoState ego)
    {
        if (paint is null)
        {
            return [];
        }

        IEnumerable<PaintedLine> lines = paint.Near(stretch.PointAt(0), LineReach);
        return PaintTracer.Trace(stretch, carOffset, 0, LineReach, paint.IsComplete ? lines : OnGround(lines, stretch, ego));
    }

    /// <summary>
    /// Measured lines, which have the heights of the road network, on the ground under the vehicle: the ground on which they were measured.
    /// </summary>
    private static IEnumerable<PaintedLine> OnGround(IEnumerable<PaintedLine> lines, RoadStretch stretch, EgoState ego)
    {
        if (ego.HeightAboveGroundMetres is not { } height)
        {
            return lines;
        }

        double station = stretch.Locate(ego.Pose.Position)?.Station ?? 0;
        var ground = new RoadGround(ego.Pose.Position - new Vector3D(0, 0, height), ego.Pose.Axes, stretch.PointAt(station).Z);
        return lines.Select(line =>
            line with
            {
                Points = [.. line.Points.Select(point => point with { World = point.World with { Z = ground.HeightAt(point.World) } })],
            }
        );
    }
}
