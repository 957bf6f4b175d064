using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Labelling;

/// <summary>What relabelling without rays, and possibly without roads, takes from recorded lanes.</summary>
internal static class RecordedLanes
{
    /// <summary>
    /// Lanes that were measured again, with the paint and hidden points of the recorded ones; for a point that is not recorded, this is
    /// unknown.
    /// </summary>
    public static LanesLabel Completed(LanesLabel lanes, LanesLabel? recorded)
    {
        var known = new Dictionary<string, bool?>();
        foreach (LaneLinePoint point in recorded?.Boundaries.SelectMany(line => line.Points) ?? [])
        {
            known[PlaceOf(point)] = point.IsHidden;
        }

        return lanes with
        {
            Boundaries =
            [
                .. lanes.Boundaries.Select(line =>
                    line with
                    {
                        Points =
                        [
                            .. line.Points.Select(point =>
                                point with
                                {
                                    IsHidden = known.TryGetValue(PlaceOf(point), out bool? hidden) ? hidden : null,
                                }
                            ),
                        ],
                    }
                ),
            ],
            Markings = lanes.Status != LaneStatus.Known || recorded?.Status == LaneStatus.Known ? recorded?.Markings : null,
        };
    }

    /// <summary>The recorded lanes as another lens shows their lines; points that it does not show are left out.</summary>
    public static LanesLabel SeenBy(Camera camera, LanesLabel recorded) =>
        recorded with
        {
            Boundaries = SeenBy(camera, recorded.Boundaries)!,
            Markings = SeenBy(camera, recorded.Markings),
        };

    private static List<LaneLineView>? SeenBy(Camera camera, IReadOnlyList<LaneLineView>? lines) =>
        lines?.SelectMany(line => RunsOf(camera, line)).ToList();

    private static IEnumerable<LaneLineView> RunsOf(Camera camera, LaneLineView line)
    {
        var run = new List<LaneLinePoint>();
        foreach (LaneLinePoint point in line.Points)
        {
            Projection projection = camera.Project(point.World);
            if (projection.Outcome == ProjectionOutcome.InImage)
            {
                run.Add(point with { Pixel = projection.Pixel });
                continue;
            }

            if (run.Count > 1)
            {
                yield return line with
                {
                    Points = run,
                };
            }

            run = [];
        }

        if (run.Count > 1)
        {
            yield return line with
            {
                Points = run,
            };
        }
    }

    /// <summary>A point's position as written in labels.</summary>
    private static string PlaceOf(LaneLinePoint point)
    {
        Vector3D place = point.World;
        return string.Join(" ", new[] { place.X, place.Y, place.Z }.Select(value => InvariantNumber.Format(value, LabelDecimals.Metres)));
    }
}
