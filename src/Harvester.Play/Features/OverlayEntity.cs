using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>What is kept of an entity from tick to tick.</summary>
/// <param name="reader">The game.</param>
/// <param name="kind">The entity's kind.</param>
/// <param name="entity">Its handle.</param>
/// <param name="number">Number of the entity in order of appearance, so that not all are read in the same tick.</param>
internal sealed class OverlayEntity(ISightReader reader, EntityKind kind, int entity, int number)
{
    /// <summary>Maximum number of ticks for which a ped that enters a vehicle keeps its box.</summary>
    private const int TicksOnFoot = 15;

    /// <summary>Interval at which props are read, ticks: signs and lights stand still, unless somebody drives into them.</summary>
    private const int TicksOfAProp = 30;

    /// <summary>
    /// Interval at which entities behind the camera are read, ticks: short enough that none crosses <see cref="MetresBehind"/> meanwhile.
    /// </summary>
    private const int TicksBehind = 8;

    private const double MetresBehind = 10;
    private ModelFacts? _model;
    private double _radius;
    private bool _isNew = true;
    private bool? _isPerson;
    private bool _isOnFoot;
    private ScaledPose? _place;

    /// <summary>The entity as drawn in this tick; null if it is not drawn.</summary>
    /// <param name="tick">Number of the tick.</param>
    /// <param name="camera">The camera.</param>
    public SeenEntity? See(long tick, Pose camera)
    {
        long turn = _isNew ? 0 : tick + number;
        _isNew = false;
        if (kind == EntityKind.Ped && !IsOnFoot(turn))
        {
            return null;
        }

        ModelFacts model = Model();
        if (_place is null || turn % TicksOfPlace(camera) == 0)
        {
            _place = reader.PlaceOf(entity);
        }

        return _place is { } place && !IsBehind(camera, place) ? new SeenEntity(model, place) : null;
    }

    private bool IsOnFoot(long turn)
    {
        _isPerson ??= reader.IsPerson(entity);
        if (_isPerson.Value && turn % TicksOnFoot == 0)
        {
            _isOnFoot = !reader.IsInVehicle(entity);
        }

        return _isOnFoot;
    }

    private ModelFacts Model()
    {
        if (_model is null)
        {
            _model = reader.FactsOf(kind, entity);
            _radius = RadiusOf(_model);
        }

        return _model;
    }

    private static double RadiusOf(ModelFacts model)
    {
        Vector3D corner = new(
            Math.Max(Math.Abs(model.Min.X), Math.Abs(model.Max.X)),
            Math.Max(Math.Abs(model.Min.Y), Math.Abs(model.Max.Y)),
            Math.Max(Math.Abs(model.Min.Z), Math.Abs(model.Max.Z))
        );
        return corner.Length;
    }

    private int TicksOfPlace(Pose camera) =>
        kind == EntityKind.Prop ? TicksOfAProp
        : _place is { } place && IsBehind(camera, place) ? TicksBehind
        : 1;

    /// <summary>Whether the whole entity is well behind the camera.</summary>
    private bool IsBehind(Pose camera, ScaledPose place)
    {
        double scale = Math.Max(place.Scale.X, Math.Max(place.Scale.Y, place.Scale.Z));
        return camera.ToLocal(place.Pose.Position).Y < -(_radius * scale) - MetresBehind;
    }
}
