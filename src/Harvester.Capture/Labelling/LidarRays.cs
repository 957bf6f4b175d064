using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Depth;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The rays of a LiDAR at one moment. With motion distortion, each is cast from where the sensor was when its column was fired, and meets
/// moving objects where they were then.
/// </summary>
internal sealed class LidarRays
{
    /// <summary>A ray goes on this far beyond what it passes through, metres.</summary>
    private const double Step = 0.001;

    /// <summary>Surfaces that a ray passes through at most.</summary>
    private const int MaxPassed = 32;

    private readonly RigLidar _lidar;
    private readonly GamePorts _game;
    private readonly Vector3D[] _directions;
    private readonly int _egoHandle;
    private readonly Pose[] _sensors;
    private readonly EntityState[] _moving;

    /// <summary>Prepares the rays of a moment.</summary>
    /// <param name="lidar">The LiDAR.</param>
    /// <param name="mount">Its pose in the frame of the vehicle's model.</param>
    /// <param name="directions">The directions of its rays in its frame, by column and within it by beam.</param>
    /// <param name="game">Casts the rays.</param>
    /// <param name="moment">The scene.</param>
    public LidarRays(RigLidar lidar, Pose mount, Vector3D[] directions, GamePorts game, SceneSnapshot moment)
    {
        (_lidar, _directions, _game, _egoHandle) = (lidar, directions, game, moment.Ego.Handle);
        Sensor = moment.Ego.Pose.Compose(mount);
        var motion = new SensorMotion(moment.Ego, mount);
        _sensors = [.. Enumerable.Range(0, lidar.Columns).Select(column => lidar.MotionDistortion ? motion.At(TimeOf(column)) : Sensor)];
        _moving = lidar.MotionDistortion ? [.. moment.Entities.Where(static entity => entity.Velocity != Vector3D.Zero)] : [];
    }

    /// <summary>The sensor's pose at the moment, which is the end of its turn.</summary>
    public Pose Sensor { get; }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast { get; private set; }

    /// <summary>The sensor's pose when a column is fired.</summary>
    public Pose SensorAt(int column) => _sensors[column];

    /// <summary>The direction of a ray in the sensor's frame.</summary>
    public Vector3D DirectionOf(int column, int beam) => _directions[(column * _lidar.BeamsDegrees.Count) + beam];

    /// <summary>The line of sight of a ray in the frame of <see cref="Sensor"/>.</summary>
    public SightLine LineOf(int column, int beam) =>
        new(Sensor.Axes.ToLocal(SensorAt(column).Axes.ToWorld(DirectionOf(column, beam))), Sensor.ToLocal(SensorAt(column).Position));

    /// <summary>Casts a ray.</summary>
    public LidarReturn? Cast(int column, int beam)
    {
        Pose sensor = SensorAt(column);
        var ray = new Ray(sensor.Position, sensor.Axes.ToWorld(DirectionOf(column, beam)));
        double reach = _lidar.RangeMetres + LidarNoise.ReachOf(_lidar);
        LidarReturn? nearest = First(ray, reach, handle => !Array.Exists(_moving, entity => entity.Handle == handle));
        foreach (EntityState entity in _moving)
        {
            // The game stands still at the moment, so instead of the object, moved back by velocity · time, the ray's origin is moved the
            // other way.
            Vector3D way = entity.Velocity * TimeOf(column);
            if (
                IsNear(ray, entity, way, nearest?.Hit.Distance ?? reach)
                && First(new Ray(ray.Origin - way, ray.Direction), reach, handle => handle == entity.Handle) is { } met
                && !(nearest?.Hit.Distance <= met.Hit.Distance)
            )
            {
                nearest = met;
            }
        }

        return nearest;
    }

    /// <summary>When a column is fired, seconds after the moment: the last one at the moment, the others before it.</summary>
    private double TimeOf(int column) => (column + 1 - _lidar.Columns) / (_lidar.Columns * _lidar.RateHz);

    /// <summary>Whether a ray may meet an object, where it was, before a distance.</summary>
    private static bool IsNear(Ray ray, EntityState entity, Vector3D way, double distance)
    {
        double radius = Math.Max(entity.ModelMin.Length, entity.ModelMax.Length);
        Vector3D centre = entity.Pose.Position + way - ray.Origin;

        // The ray passes the object's sphere: |centre|² - (centre · direction)² ≤ radius², ahead of the origin and before the distance.
        double along = centre.Dot(ray.Direction);
        return along > -radius && along - radius < distance && centre.LengthSquared - (along * along) <= radius * radius;
    }

    /// <summary>The first hit of a ray on an accepted entity; it passes through all others.</summary>
    private LidarReturn? First(Ray ray, double reach, Func<int, bool> accepts)
    {
        double passed = 0;
        for (int surfaces = 0; surfaces <= MaxPassed && passed < reach; surfaces++)
        {
            if (Measure(passed > 0 ? new Ray(ray.At(passed), ray.Direction) : ray, reach - passed, out Vector3D normal) is not { } hit)
            {
                return null;
            }

            if (accepts(hit.Entity))
            {
                return new LidarReturn(hit with { Distance = passed + hit.Distance }, normal, false);
            }

            passed += hit.Distance + Step;
        }

        return null;
    }

    private RayHit? Measure(Ray ray, double reach, out Vector3D normal)
    {
        RaysCast++;
        normal = Vector3D.Zero;
        return _game.SurfaceRays is { } surfaces
            ? surfaces.Cast(ray, reach, _egoHandle, out normal)
            : _game.Rays.Cast(ray, reach, _egoHandle);
    }
}
