using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The numbers that a harvest gave to objects, from its first frame to its last: an object that is labelled again, and earlier than it was
/// then, has its number all the same.
/// </summary>
public sealed class RecordedIds
{
    private readonly Dictionary<(int Handle, int? Face, string Model, ObjectClass Class), ushort> _ids = [];

    /// <summary>The greatest number; 0 when there is none.</summary>
    public int Greatest { get; private set; }

    /// <summary>Adds the numbers of a scene; of two numbers of one object the first stays.</summary>
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
