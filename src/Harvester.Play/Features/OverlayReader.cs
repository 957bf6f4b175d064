using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// Reads what the overlay draws. Labels read everything in every tick; the overlay need not: a model is read once, hidden entities rarely,
/// and values that change slowly now and then.
/// </summary>
/// <param name="reader">The game.</param>
public sealed class OverlayReader(ISightReader reader)
{
    /// <summary>Interval at which near plane and window shape are read, ticks.</summary>
    private const int TicksOfTheWindow = 30;

    /// <summary>
    /// Interval at which the lists are read, ticks: new entities appear after at most that long. A removed entity disappears at once, as
    /// its pose cannot be read.
    /// </summary>
    private const int TicksOfTheLists = 6;

    private static readonly EntityKind[] Kinds = [EntityKind.Vehicle, EntityKind.Ped, EntityKind.Prop];
    private Dictionary<(EntityKind Kind, int Entity), OverlayEntity> _known = [];
    private ModelFacts? _egoModel;
    private int _egoVehicle;
    private long _tick;
    private long? _listedAt;
    private int _met;
    private double _nearClip;
    private double _aspect;

    /// <summary>The camera; call it once per tick, before anything else.</summary>
    public CameraState ReadCamera()
    {
        if (_tick++ % TicksOfTheWindow == 0)
        {
            _nearClip = reader.NearClip;
            _aspect = reader.WindowAspect;
        }

        return new CameraState(reader.CameraPose, reader.VerticalFovDegrees, _nearClip, _aspect);
    }

    /// <summary>The vehicle that carries the camera; null if it is not mounted.</summary>
    public SeenEntity? ReadEgo()
    {
        int vehicle = reader.MountedVehicle;
        if (vehicle == 0)
        {
            return null;
        }

        if (vehicle != _egoVehicle)
        {
            _egoVehicle = vehicle;
            _egoModel = reader.FactsOf(EntityKind.Vehicle, vehicle);
        }

        return reader.PlaceOf(vehicle) is { } place ? new SeenEntity(_egoModel!, place) : null;
    }

    /// <summary>The entities near the camera that may be visible.</summary>
    /// <param name="camera">The camera's pose.</param>
    /// <param name="range">Metres.</param>
    public IReadOnlyList<SeenEntity> Around(Pose camera, double range)
    {
        if (_listedAt is not { } listed || _tick - listed >= TicksOfTheLists)
        {
            _listedAt = _tick;
            List(camera, range);
        }

        return [.. _known.Values.Select(sighting => sighting.See(_tick, camera)).OfType<SeenEntity>()];
    }

    /// <summary>Removes what is no longer listed: its handle may be reused for another entity.</summary>
    private void List(Pose camera, double range) =>
        _known = Kinds
            .SelectMany(kind => reader.Near(kind, camera.Position, range).Select(entity => (kind, entity)))
            .Distinct()
            .ToDictionary(
                key => key,
                key => _known.TryGetValue(key, out OverlayEntity? known) ? known : new OverlayEntity(reader, key.kind, key.entity, _met++)
            );
}
