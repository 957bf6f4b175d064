using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Estimates how much of an object in a pixel map is hidden. Its visible pixels are counted in the map. To these, the pixels that would be
/// visible without the things in front are added: of the silhouette's other pixels, the fraction at which a ray that starts at the object's
/// cuboid hits the object, estimated from a few of them spread evenly. So the gaps between an object and its cuboid do not count as hidden.
/// </summary>
public sealed class MapOcclusionEstimator
{
    private readonly Camera _camera;
    private readonly InstanceMap _map;
    private readonly int _ignoredEntity;
    private readonly IRayCaster _rays;
    private readonly int _probes;

    /// <summary>Creates an estimator for a map.</summary>
    /// <param name="camera">The map's camera.</param>
    /// <param name="map">The map.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <param name="probes">Maximum number of rays per object; at least 1.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">Fewer than 1 probe.</exception>
    public MapOcclusionEstimator(Camera camera, InstanceMap map, int ignoredEntity, IRayCaster rays, int probes)
    {
        _camera = Guard.NotNull(camera, nameof(camera));
        _map = Guard.NotNull(map, nameof(map));
        _ignoredEntity = ignoredEntity;
        _rays = Guard.NotNull(rays, nameof(rays));
        _probes = Guard.AtLeast(probes, 1, nameof(probes));
    }

    /// <summary>Estimates how much of a target is hidden.</summary>
    /// <param name="target">The target.</param>
    /// <param name="sight">What the mapper found. Rays are cast only for a target that is seen or unseen.</param>
    /// <returns>The estimate; method <see cref="OcclusionMethod.None"/> if nothing of the object is in the image, or nothing is known of
    /// it.</returns>
    public OcclusionEstimate Estimate(MapTarget target, Sight sight)
    {
        if (Guard.NotNull(target, nameof(target)).Projection.Box is not { } box || sight is Sight.NotAsked or Sight.Undetermined)
        {
            return new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = sight };
        }

        var spans = new SilhouetteSpans(target.Projection.Silhouette, box, _camera.Image);
        int visible = VisiblePixels(target, spans);
        int others = spans.PixelCount - VisibleInSilhouette(target, spans);
        int cast = 0;
        int met = 0;
        var probe = new EntityProbe(_camera, new TargetView(target, spans), _ignoredEntity, _rays);
        foreach ((int column, int row) in probe.Spread(others > 0 ? _probes : 0, (c, r) => _map[c, r] == target.Number))
        {
            // An object without a visible pixel is hidden completely.
            if (met > 0 && visible == 0)
            {
                break;
            }

            cast++;
            met += probe.Meets(column, row) ? 1 : 0;
        }

        // Of the silhouette's other pixels, the share met / cast shows the object once nothing is in front: hidden = others · met / cast.
        // The fraction is hidden / (visible + hidden).
        double hidden = cast == 0 ? 0 : (double)others * met / cast;
        return visible + hidden > 0
            ? new OcclusionEstimate(hidden / (visible + hidden), visible, cast, OcclusionMethod.PixelMap) { Sight = sight }
            : new OcclusionEstimate(0, 0, cast, OcclusionMethod.None) { Sight = Sight.Unseen };
    }

    // An outline between rays may lie a pixel outside the silhouette, so all of the box is counted.
    private int VisiblePixels(MapTarget target, SilhouetteSpans spans)
    {
        int visible = 0;
        for (int row = spans.FirstRow; row <= spans.LastRow; row++)
        {
            for (int column = spans.FirstColumn; column <= spans.LastColumn; column++)
            {
                visible += _map[column, row] == target.Number ? 1 : 0;
            }
        }

        return visible;
    }

    private int VisibleInSilhouette(MapTarget target, SilhouetteSpans spans)
    {
        int visible = 0;
        for (int row = spans.FirstRow; row <= spans.LastRow; row++)
        {
            (int first, int last) = spans.Row(row);
            for (int column = first; column <= last; column++)
            {
                visible += _map[column, row] == target.Number ? 1 : 0;
            }
        }

        return visible;
    }
}
