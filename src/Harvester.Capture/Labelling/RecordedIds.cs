using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The ids that a harvest assigned to objects, over all its frames: an object that relabelling lists earlier than the harvest did still
/// gets its id.
/// </summary>
public sealed class RecordedIds
{
    private readonly Dictionary<(int Handle, int? Face, string Model, ObjectClass Class), ushort> _ids = [];

    /// <summary>The greatest id; 0 if there is none.</summary>
    public int Greatest { get; private set; }

    /// <summary>Adds the ids of a scene; of two ids of one object the first is kept.</summary>
    public void Add(RecordedScene scene)
    {
        if (scene is null)
        {
            throw new ArgumentNullException(nameof(scene));
        }

        Dictionary<int, EntityState> entities = scene.Snapshot.Entities.ToDictionary(entity => entity.Handle);
        foreach (KeyValuePair<int, int> id in scene.Ids)
        {
            Add(entities[id.Key], null, id.Value);
        }

        foreach (RecordedOcclusion found in scene.Occlusions)
        {
            Add(entities[found.Handle], found.Face, found.Id);
        }
    }

    /// <summary>Keeps an id from being given to another object: an event names it.</summary>
    /// <param name="id">The id, 1 to 65,535.</param>
    public void Reserve(int id) => Greatest = Math.Max(Greatest, id);

    internal ushort? Find(EntityState entity, int? face) =>
        _ids.TryGetValue((entity.Handle, face, entity.Model, entity.Class), out ushort id) ? id : null;

    private void Add(EntityState entity, int? face, int id)
    {
        (int, int?, string, ObjectClass) key = (entity.Handle, face, entity.Model, entity.Class);
        if (!_ids.ContainsKey(key))
        {
            _ids.Add(key, (ushort)id);
        }

        Greatest = Math.Max(Greatest, id);
    }
}
