using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Measures a frozen moment with a radar. Rays through its sector find the surfaces that face it; what they meet in one cell of angle and
/// range is an echo, and echoes that are strong enough for their distance are detections. docs/radar.md describes the model.
/// </summary>
/// <param name="radar">The radar.</param>
/// <param name="mount">Its pose in the frame of the vehicle's model.</param>
/// <param name="options">What is labelled; objects of other classes have no id.</param>
/// <param name="game">Casts the rays, which pass through the vehicle that carries the radar.</param>
/// <param name="registry">The ids of the objects.</param>
internal sealed class RadarScanner(RigRadar radar, Pose mount, LabellingOptions options, GamePorts game, ObjectRegistry registry)
{
    /// <summary>A radar of the range R detects this cross-section at R, m².</summary>
    private const double ReferenceSection = 10;

    private const double MinMetres = 0.2;

    private readonly RigLidar _rays = new(
        radar.Name,
        radar.Mount,
        [.. Enumerable.Range(0, RigRadar.Rows).Select(row => radar.ElevationDegrees * (((row + 0.5) / RigRadar.Rows) - 0.5))],
        radar.Columns * RigRadar.RaysPerCell,
        1,
        MinMetres,
        radar.RangeMetres
    );

    /// <summary>Gives an id to every object within range, detected or not, as a LiDAR does.</summary>
    public void AssignIds(SceneSnapshot moment)
    {
        Vector3D eye = moment.Ego.Pose.Compose(mount).Position;
        foreach (EntityState entity in moment.Entities.Where(entity => HasId(entity, eye)))
        {
            registry.IdOf(entity);
        }
    }

    /// <summary>Measures a moment in steps, one for each column of rays.</summary>
    /// <param name="moment">The moment.</param>
    /// <param name="scan">Receives the detections.</param>
    public IEnumerable<WorkStep> Scan(SceneSnapshot moment, WorkResult<RadarScan> scan)
    {
        Vector3D[] directions = [.. Directions()];
        var rays = new LidarRays(_rays, mount, directions, game, moment);
        var met = new List<(int Column, Vector3D Direction, LidarReturn Return)>();
        for (int column = 0; column < _rays.Columns; column++)
        {
            for (int row = 0; row < RigRadar.Rows; row++)
            {
                if (rays.Cast(column, row) is { } hit && hit.Hit.Distance >= MinMetres)
                {
                    met.Add((column, rays.DirectionOf(column, row), hit));
                }
            }

            yield return WorkStep.Pause;
        }

        Dictionary<int, EntityState> entities = moment.Entities.ToDictionary(static entity => entity.Handle);
        Vector3D carried = VelocityOfSensor(moment.Ego, rays.Sensor);
        var errors = new RadarErrors(radar, moment.GameFrame);
        var found = new List<RadarDetection>();
        foreach (RadarEcho echo in EchoesOf(met, entities, rays.Sensor))
        {
            if (IsDetected(echo))
            {
                RadarDetection exact = DetectionOf(echo, entities, rays.Sensor, carried);
                found.Add(errors.Measured(exact));
                if (errors.GhostOf(exact) is { } ghost)
                {
                    found.Add(errors.Measured(ghost));
                }
            }
        }

        found.AddRange(errors.Clutter(direction => -carried.Dot(rays.Sensor.Axes.ToWorld(direction))).Select(errors.Measured));

        // The received power of the radar equation is proportional to σ / R⁴.
        scan.Value = new RadarScan(
            radar.Name,
            rays.RaysCast,
            [
                .. found
                    .OrderByDescending(static each => each.CrossSection - (40 * Math.Log10(each.Range)))
                    .Take(radar.MaxDetections)
                    .OrderBy(static each => each.Range),
            ]
        );
    }

    /// <summary>The echoes of all cells, by the nearest surface of each object, or of the surroundings, in it.</summary>
    private IEnumerable<RadarEcho> EchoesOf(
        List<(int Column, Vector3D Direction, LidarReturn Return)> met,
        Dictionary<int, EntityState> entities,
        Pose sensor
    )
    {
        Dictionary<int, int> raysOf = met.GroupBy(static each => each.Return.Hit.Entity)
            .ToDictionary(static each => each.Key, static each => each.Count());
        return met.GroupBy(each =>
                (
                    Cell: each.Column / RigRadar.RaysPerCell,
                    Range: (int)(each.Return.Hit.Distance / radar.RangeStepMetres),
                    each.Return.Hit.Entity
                )
            )
            .Select(cell =>
            {
                (_, Vector3D direction, LidarReturn nearest) = cell.OrderBy(static each => each.Return.Hit.Distance).First();

                // An object's cross-section is divided among the rays that meet it; that of surroundings adds up over theirs.
                double section = entities.TryGetValue(cell.Key.Entity, out EntityState? entity)
                    ? SectionOf(entity, sensor) * cell.Count() / raysOf[cell.Key.Entity]
                    : cell.Sum(each => SurfaceSection(each.Direction, each.Return, sensor));
                return new RadarEcho(nearest.Hit.Distance, direction, cell.Key.Entity, section);
            });
    }

    private static double SectionOf(EntityState entity, Pose sensor)
    {
        Vector3D towards = entity.Pose.ToLocal(sensor.Position);
        return RadarCrossSection.Of(entity.Class, Math.Atan2(towards.X, towards.Y));
    }

    /// <summary>
    /// What a ray lights of the surroundings: its part of the sphere, times what the material reflects, times cos² of incidence.
    /// </summary>
    private double SurfaceSection(Vector3D direction, LidarReturn met, Pose sensor)
    {
        SemanticClass kind =
            met.Hit.Entity == RayHit.World ? options.Materials.ClassOf(met.Hit.Material, met.Hit.NormalZ) : SemanticClass.Other;
        double cosine = met.Normal == Vector3D.Zero ? 1 : Math.Abs(sensor.Axes.ToWorld(direction).Dot(met.Normal));
        double width = Angles.ToRadians(radar.AzimuthStepDegrees / RigRadar.RaysPerCell) * met.Hit.Distance;
        double height = Angles.ToRadians(radar.ElevationDegrees / RigRadar.Rows) * met.Hit.Distance;
        return RadarCrossSection.OfSurface(kind) * width * height * cosine * cosine;
    }

    /// <summary>Whether an echo is strong enough: what is received is proportional to σ / R⁴.</summary>
    private bool IsDetected(RadarEcho echo) => echo.CrossSection >= ReferenceSection * Math.Pow(echo.Range / radar.RangeMetres, 4);

    private RadarDetection DetectionOf(RadarEcho echo, Dictionary<int, EntityState> entities, Pose sensor, Vector3D carried)
    {
        EntityState? entity = entities.TryGetValue(echo.Entity, out EntityState? known) ? known : null;
        Vector3D line = sensor.Axes.ToWorld(echo.Direction);

        // The distance changes by the difference of the velocities along the line of sight.
        double ground = (entity?.Velocity ?? Vector3D.Zero).Dot(line);
        return new RadarDetection(
            echo.Range,
            Angles.ToDegrees(Math.Atan2(-echo.Direction.X, echo.Direction.Y)),
            Angles.ToDegrees(Math.Asin(echo.Direction.Z)),
            ground - carried.Dot(line),
            ground,
            10 * Math.Log10(echo.CrossSection),
            entity is not null && HasId(entity, sensor.Position) ? registry.IdOf(entity) : 0,
            RadarOrigin.Target
        );
    }

    /// <summary>
    /// The velocity of the sensor in the world: that of the vehicle, and its turning about the vertical times the arm, v + ω × r.
    /// </summary>
    private static Vector3D VelocityOfSensor(EgoState ego, Pose sensor) =>
        ego.Velocity + new Vector3D(0, 0, ego.Motion?.YawRate ?? 0).Cross(sensor.Position - ego.Pose.Position);

    private bool HasId(EntityState entity, Vector3D eye) =>
        (options.Classes?.Contains(entity.Class) ?? true)
        && (entity.Pose.Position - eye).Length < options.RangeMetres
        && (entity.Pose.Position - eye).Length - Math.Max(entity.ModelMin.Length, entity.ModelMax.Length) <= radar.RangeMetres;

    /// <summary>The directions of the rays in the sensor's frame, from left to right and in each column from below.</summary>
    private IEnumerable<Vector3D> Directions()
    {
        for (int column = 0; column < _rays.Columns; column++)
        {
            double azimuth = Angles.ToRadians(radar.AzimuthDegrees * (0.5 - ((column + 0.5) / _rays.Columns)));
            foreach (double degrees in _rays.BeamsDegrees)
            {
                double elevation = Angles.ToRadians(degrees);
                yield return new Vector3D(
                    -Math.Cos(elevation) * Math.Sin(azimuth),
                    Math.Cos(elevation) * Math.Cos(azimuth),
                    Math.Sin(elevation)
                );
            }
        }
    }
}
