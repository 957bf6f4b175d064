using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// The painter's algorithm on cuboids' silhouettes: the farthest first, nearer ones over it. It needs no rays, ignores the world between
/// the objects, and fills the gaps between a cuboid and the object in it.
/// </summary>
public static class SilhouettePainter
{
    /// <summary>Paints targets by the distance of their cuboids' centres from the camera.</summary>
    /// <param name="camera">The camera of the targets' projections.</param>
    /// <param name="targets">The targets, in any order.</param>
    public static InstanceMap Paint(Camera camera, IReadOnlyList<MapTarget> targets)
    {
        var map = new InstanceMap(Guard.NotNull(camera, nameof(camera)).Image);
        var farthestFirst = new List<MapTarget>(Guard.NotNull(targets, nameof(targets)));
        farthestFirst.Sort(
            (a, b) =>
            {
                int byDistance = DistanceOf(camera, b).CompareTo(DistanceOf(camera, a));
                return byDistance != 0 ? byDistance : a.Number.CompareTo(b.Number);
            }
        );
        foreach (MapTarget target in farthestFirst)
        {
            if (target.Projection.Box is { } box)
            {
                var spans = new SilhouetteSpans(target.Projection.Silhouette, box, camera.Image);
                for (int row = spans.FirstRow; row <= spans.LastRow; row++)
                {
                    (int first, int last) = spans.Row(row);
                    for (int column = first; column <= last; column++)
                    {
                        map[column, row] = target.Number;
                    }
                }
            }
        }

        return map;
    }

    internal static double DistanceOf(Camera camera, MapTarget target) => (target.Cuboid.Centre - camera.Pose.Position).Length;
}
