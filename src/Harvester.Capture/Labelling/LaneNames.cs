using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Names the lanes on which the ego and the vehicles are, and those that lights and signs govern, as docs/maps.md names them.
/// </summary>
internal static class LaneNames
{
    /// <summary>How far ahead of the ego a lane may begin, metres along the lanes: as far as boundaries are traced.</summary>
    private const double Range = 70;

    /// <summary>The place of the car whose lane is named: the middle of its box, metres, world.</summary>
    public static Vector3D CentreOf(EgoState ego) => ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);

    /// <summary>The lanes with the names of the ego's lane and of those ahead of it.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="seen">What they were made of.</param>
    /// <param name="ego">The car.</param>
    /// <param name="maps">The map.</param>
    public static LanesLabel Named(LanesLabel lanes, LaneObservation seen, EgoState ego, LaneMaps maps)
    {
        Vector3D centre = CentreOf(ego);
        MapLane? lane = maps.Around(centre) is { } map ? Followed(map, seen, centre) ?? map.Index.At(centre, ego.Pose.Axes.Forward) : null;
        return lanes with
        {
            LaneId = lane?.Id,
            LanesAhead = lane is null ? [] : [.. LanesAhead.From(lane, centre, Range).Select(ahead => ahead.Id)],
        };
    }

    /// <summary>Names the lanes of the labelled vehicles, in steps.</summary>
    /// <param name="draft">The frame, whose labels it changes.</param>
    /// <param name="maps">The map.</param>
    public static IEnumerable<WorkStep> NameVehicles(FrameDraft draft, LaneMaps maps)
    {
        var found = new Dictionary<int, string>();
        foreach (ObjectLabel label in draft.Objects.Where(label => label.Parent is null && VehicleClasses.AreVehicles(label.Class)))
        {
            yield return WorkStep.Do(maps.MakeAround(label.Box3D.Centre));
            if (maps.Around(label.Box3D.Centre)?.Index.At(label.Box3D.Centre, label.Box3D.Axes.Forward) is { } lane)
            {
                found.Add(label.Id, lane.Id);
            }

            yield return WorkStep.Pause;
        }

        draft.Update(label => label with { LaneId = found.TryGetValue(label.Id, out string? lane) ? lane : null });
    }

    /// <summary>Names the lanes that the labelled lights and signs govern, in steps.</summary>
    /// <param name="draft">The frame, whose labels it changes.</param>
    /// <param name="ids">The ids of the entities that have one, by handle.</param>
    /// <param name="maps">The map.</param>
    public static IEnumerable<WorkStep> NameGoverned(FrameDraft draft, IReadOnlyDictionary<int, int> ids, LaneMaps maps)
    {
        // A part may be labelled without the post that it is on.
        HashSet<int> wanted = [.. draft.Objects.Select(label => label.Parent ?? label.Id)];
        var found = new Dictionary<int, IReadOnlyList<string>>();
        foreach (EntityState entity in draft.Snapshot.Entities)
        {
            if (ids.TryGetValue(entity.Handle, out int id) && wanted.Contains(id) && MapProps.Of(entity.Model, entity.Pose) is { } prop)
            {
                yield return WorkStep.Do(maps.MakeAround(prop.Position));
                found[id] = maps.Around(prop.Position) is { } map
                    ? [.. SignalLanes.Of(map, prop.Position, prop.Facing, prop.Kind).Select(lane => lane.Id)]
                    : [];
                yield return WorkStep.Pause;
            }
        }

        draft.Update(label =>
            label with
            {
                GovernedLanes = found.TryGetValue(label.Parent ?? label.Id, out IReadOnlyList<string>? lanes) ? lanes : null,
            }
        );
    }

    /// <summary>
    /// The lane of the road that the car follows: known from the frames before, and from measured paint. Null if that is not known, and on
    /// ways through junctions.
    /// </summary>
    private static MapLane? Followed(LaneNetwork map, LaneObservation seen, Vector3D centre) =>
        seen.Status == LaneStatus.Known && seen.Match.Lane is { } index
            ? map.LaneOf(seen.Match.Link, seen.Match.IsForward, index, centre)
            : null;
}
