using System;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>What is remembered of an entity from tick to tick.</summary>
/// <param name="reader">The game.</param>
/// <param name="kind">The entity's kind.</param>
/// <param name="entity">Its handle.</param>
/// <param name="number">Counts the entities met, so that not all are asked after in the same tick.</param>
internal sealed class Sighting(ISightReader reader, EntityKind kind, int entity, int number)
{
    /// <summary>A ped that gets into a vehicle keeps its box for so many ticks at most.</summary>
    private const int TicksOnFoot = 15;

    /// <summary>Signs and lights stand still, unless somebody drives into them.</summary>
    private const int TicksOfAProp = 30;

    /// <summary>
    /// What is behind the camera need only be found when it comes before it: in so many ticks nothing covers <see cref="MetresBehind"/>.
    /// </summary>
    private const int TicksBehind = 8;

    private const double MetresBehind = 10;
    private ModelFacts? _model;
    private double _radius;
    private bool _isNew = true;
    private bool? _isPerson;
    private bool _isOnFoot;
    private ScaledPose? _place;

    /// <summary>The entity as it is drawn in this tick; null when it is not.</summary>
    /// <param name="tick">Counts the ticks.</param>
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
            Math.Max(Math.Abs(model.Min.Z), Math.Abs(model.Max.Z)));
        return corner.Length;
    }

    private int TicksOfPlace(Pose camera) =>
        kind == EntityKind.Prop ? TicksOfAProp : _place is { } place && IsBehind(camera, place) ? TicksBehind : 1;

    /// <summary>Whether the whole entity is well behind the camera.</summary>
    private bool IsBehind(Pose camera, ScaledPose place)
    {
        double scale = Math.Max(place.Scale.X, Math.Max(place.Scale.Y, place.Scale.Z));
        return camera.ToLocal(place.Pose.Position).Y < -(_radius * scale) - MetresBehind;
    }
}
