using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>Measures a frozen moment with a LiDAR: a ray for each beam of each firing of one turn.</summary>
/// <param name="lidar">The LiDAR.</param>
/// <param name="mount">Its pose in the frame of the vehicle's model.</param>
/// <param name="options">What is labelled; objects of other classes have no id.</param>
/// <param name="game">Casts the rays, which pass through the vehicle that carries the LiDAR.</param>
/// <param name="registry">The ids of the objects.</param>
internal sealed class LidarScanner(RigLidar lidar, Pose mount, LabellingOptions options, GamePorts game, ObjectRegistry registry)
{
    private readonly Vector3D[] _directions = [.. DirectionsOf(lidar)];

    /// <summary>
    /// Gives an id to every object within range, hit or not, so that ids do not depend on which moments of a session are measured.
    /// </summary>
    public void AssignIds(SceneSnapshot moment)
    {
        Vector3D eye = moment.Ego.Pose.Compose(mount).Position;
        foreach (EntityState entity in moment.Entities.Where(entity => HasId(entity, eye)))
        {
            registry.IdOf(entity);
        }
    }

    /// <summary>Measures a moment in steps, one for each firing.</summary>
    /// <param name="moment">The moment.</param>
    /// <param name="sweep">Receives the sweep.</param>
    public IEnumerable<WorkStep> Scan(SceneSnapshot moment, WorkResult<LidarSweep> sweep)
    {
        Pose sensor = moment.Ego.Pose.Compose(mount);
        Dictionary<int, (ushort Id, SemanticClass Class)> entities = moment.Entities.ToDictionary(
            entity => entity.Handle,
            entity => (HasId(entity, sensor.Position) ? registry.IdOf(entity) : (ushort)0, SemanticClasses.Of(entity.Class))
        );
        var rays = new LidarRays(lidar, mount, _directions, game, moment);
        var returns = new LidarReturn?[lidar.Columns, lidar.BeamsDegrees.Count];
        var turn = IsInterpolated ? new LidarTurn(lidar, rays) : null;
        if (turn is not null)
        {
            while (turn.Step())
            {
                yield return WorkStep.Pause;
            }

            returns = turn.Complete();
            yield return WorkStep.Pause;
        }

        for (int column = 0; turn is null && column < lidar.Columns; column++)
        {
            for (int beam = 0; beam < lidar.BeamsDegrees.Count; beam++)
            {
                returns[column, beam] = rays.Cast(column, beam);
            }

            yield return WorkStep.Pause;
        }

        var noise = new LidarNoise(lidar, moment.GameFrame);
        var points = new List<LidarPoint>();
        for (int column = 0; column < lidar.Columns; column++)
        {
            for (int beam = 0; beam < lidar.BeamsDegrees.Count; beam++)
            {
                if (
                    returns[column, beam] is { } met
                    && noise.Measured(met.Hit.Distance) is var distance
                    && distance >= lidar.MinRangeMetres
                    && distance <= lidar.RangeMetres
                    && !noise.IsLost()
                )
                {
                    Vector3D normal = rays.SensorAt(column).Axes.ToLocal(met.Normal);
                    points.Add(
                        PointOf(met.Hit, rays.DirectionOf(column, beam), distance, normal, entities) with
                        {
                            Column = (ushort)column,
                            Beam = (ushort)beam,
                            IsInterpolated = met.IsInterpolated,
                        }
                    );
                }
            }
        }

        sweep.Value = new LidarSweep(lidar.Name, points, rays.RaysCast);
    }

    /// <summary>
    /// The points of a sweep that lie exactly on surfaces at the moment, world, metres: none of a LiDAR with noise or motion distortion.
    /// </summary>
    public IEnumerable<Vector3D> ExactPointsOf(LidarSweep sweep, SceneSnapshot moment)
    {
        Pose sensor = moment.Ego.Pose.Compose(mount);
        return lidar.RangeNoiseMetres > 0 || lidar.MotionDistortion
            ? []
            : sweep
                .Points.Where(static point => !point.IsInterpolated)
                .Select(point => sensor.ToWorld(new Vector3D(point.X, point.Y, point.Z)));
    }

    /// <summary>Whether only a part of the rays is cast: interpolation needs the planes of the surfaces.</summary>
    private bool IsInterpolated =>
        lidar.RayFraction < 1 && game.SurfaceRays is not null && lidar is { Columns: > 1, BeamsDegrees.Count: > 1 };

    private LidarPoint PointOf(
        RayHit hit,
        Vector3D direction,
        double distance,
        Vector3D normal,
        Dictionary<int, (ushort Id, SemanticClass Class)> entities
    )
    {
        (ushort id, SemanticClass kind) =
            hit.Entity == RayHit.World ? ((ushort)0, options.Materials.ClassOf(hit.Material, hit.NormalZ))
            : entities.TryGetValue(hit.Entity, out (ushort Id, SemanticClass Class) known) ? known
            : ((ushort)0, SemanticClass.Other);
        Vector3D place = direction * distance;
        return new LidarPoint(
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            (float)LidarIntensity.Of(kind, direction, normal),
            0,
            0,
            id,
            kind
        );
    }

    /// <summary>Whether an object within the labelling range is labelled and may be hit.</summary>
    private bool HasId(EntityState entity, Vector3D eye) =>
        (options.Classes?.Contains(entity.Class) ?? true)
        && (entity.Pose.Position - eye).Length < options.RangeMetres
        && (entity.Pose.Position - eye).Length - Math.Max(entity.ModelMin.Length, entity.ModelMax.Length) <= lidar.RangeMetres;

    /// <summary>The directions of the rays in the sensor's frame: column by column, clockwise from behind.</summary>
    private static IEnumerable<Vector3D> DirectionsOf(RigLidar lidar)
    {
        for (int column = 0; column < lidar.Columns; column++)
        {
            // Azimuth from -180°, straight behind, clockwise as seen from above; direction = (cos e sin a, cos e cos a, sin e): right,
            // forward, up.
            double azimuth = (2 * Math.PI * column / lidar.Columns) - Math.PI;
            foreach (double degrees in lidar.BeamsDegrees)
            {
                double elevation = Angles.ToRadians(degrees);
                yield return new Vector3D(
                    Math.Cos(elevation) * Math.Sin(azimuth),
                    Math.Cos(elevation) * Math.Cos(azimuth),
                    Math.Sin(elevation)
                );
            }
        }
    }
}
