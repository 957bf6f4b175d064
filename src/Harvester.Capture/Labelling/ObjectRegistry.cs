using System.Collections.Generic;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Gives objects numbers that stay the same for a session. The game gives handles again to later entities: a handle whose model or
/// class has changed is a new object.
/// </summary>
/// <param name="firstId">The first number to give.</param>
internal sealed class ObjectRegistry(int firstId)
{
    /// <summary>The greatest number that a 16-bit mask can hold.</summary>
    public const int GreatestId = ushort.MaxValue;

    private readonly Dictionary<(int Handle, int? Face), (string Model, ObjectClass Class, ushort Id)> _objects = [];
    private int _nextId = firstId;

    /// <summary>The number of an entity, or of one of its faces.</summary>
    /// <param name="entity">The entity.</param>
    /// <param name="face">The face's number on its model; null for the entity itself.</param>
    /// <exception cref="HarvestFaultException">All numbers are used up.</exception>
    public ushort IdOf(EntityState entity, int? face = null)
    {
        if (_objects.TryGetValue((entity.Handle, face), out (string Model, ObjectClass Class, ushort Id) known)
            && known.Model == entity.Model && known.Class == entity.Class)
        {
            return known.Id;
        }

        if (_nextId > GreatestId)
        {
            throw new HarvestFaultException("This session has used all 65,535 object numbers. Start a new session to go on.");
        }

        ushort id = (ushort)_nextId++;
        _objects[(entity.Handle, face)] = (entity.Model, entity.Class, id);
        return id;
    }
}
