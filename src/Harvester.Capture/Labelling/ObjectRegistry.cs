using Harvester.Capture.Faults;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Gives objects ids that stay the same for a session. The game reuses handles: a handle whose model or class has changed is a new object.
/// </summary>
/// <param name="firstId">The first id to assign.</param>
internal sealed class ObjectRegistry(int firstId)
{
    /// <summary>The greatest number that a 16-bit mask can hold.</summary>
    public const int MaxId = ushort.MaxValue;

    private readonly Dictionary<(int Handle, int? Face), (string Model, ObjectClass Class, ushort Id)> _objects = [];
    private int _nextId = firstId;

    /// <summary>Ids that the harvest assigned, when its labels are recomputed; otherwise null.</summary>
    public RecordedIds? Recorded { get; init; }

    /// <summary>The id of an entity, or of one of its faces.</summary>
    /// <param name="entity">The entity.</param>
    /// <param name="face">The face's number on its model; null for the entity itself.</param>
    /// <exception cref="HarvestFaultException">All ids are used up.</exception>
    public ushort IdOf(EntityState entity, int? face = null)
    {
        if (Known(entity, face) is { } known)
        {
            return known;
        }

        if (Recorded?.Find(entity, face) is not { } id)
        {
            if (_nextId > MaxId)
            {
                throw new HarvestFaultException(
                    new CaptureFault(FaultCode.NumbersUsedUp, "This session has used all 65,535 object numbers. Start a new session.")
                );
            }

            id = (ushort)_nextId++;
        }

        _objects[(entity.Handle, face)] = (entity.Model, entity.Class, id);
        return id;
    }

    /// <summary>The ids of the entities that have one, by handle.</summary>
    public IReadOnlyDictionary<int, int> IdsOf(IEnumerable<EntityState> entities) =>
        entities
            .Select(entity => (entity.Handle, Id: Known(entity, null)))
            .Where(entity => entity.Id is not null)
            .ToDictionary(entity => entity.Handle, entity => (int)entity.Id!.Value);

    /// <summary>Takes over the ids of a recorded scene; they take precedence over those of earlier scenes.</summary>
    public void Remember(RecordedScene scene)
    {
        Dictionary<int, EntityState> entities = scene.Snapshot.Entities.ToDictionary(entity => entity.Handle);
        foreach (KeyValuePair<int, int> id in scene.Ids)
        {
            Remember(entities[id.Key], null, id.Value);
        }

        foreach (RecordedOcclusion found in scene.Occlusions)
        {
            Remember(entities[found.Handle], found.Face, found.Id);
        }
    }

    private void Remember(EntityState entity, int? face, int id) =>
        _objects[(entity.Handle, face)] = (entity.Model, entity.Class, (ushort)id);

    private ushort? Known(EntityState entity, int? face) =>
        _objects.TryGetValue((entity.Handle, face), out (string Model, ObjectClass Class, ushort Id) known)
        && known.Model == entity.Model
        && known.Class == entity.Class
            ? known.Id
            : null;
}
