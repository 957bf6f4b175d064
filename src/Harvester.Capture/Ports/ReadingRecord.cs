using System.Collections.Generic;

namespace Harvester.Capture.Ports;

/// <summary>Keeps what could not be read of a game as it should be. The game's reader fills it, a harvest begins and reports it.</summary>
public sealed class ReadingRecord
{
    private readonly HashSet<int> _distorted = [];
    private readonly HashSet<EntityKind> _listedByNatives = [];

    /// <summary>What a session records.</summary>
    public ReadingReport Report =>
        new(SourceOf(EntityKind.Vehicle), SourceOf(EntityKind.Ped), SourceOf(EntityKind.Prop), _distorted.Count);

    /// <summary>Resets the counters. The sources of the lists are kept.</summary>
    public void Begin() => _distorted.Clear();

    /// <summary>Counts an entity that was left out because its matrix is sheared or mirrored; each once.</summary>
    public void AddDistorted(int entity) => _distorted.Add(entity);

    /// <summary>From now on entities of a kind are listed by natives.</summary>
    public void ListByNatives(EntityKind kind) => _listedByNatives.Add(kind);

    /// <summary>Where entities of a kind are listed from.</summary>
    public ListSource SourceOf(EntityKind kind) => _listedByNatives.Contains(kind) ? ListSource.Natives : ListSource.Api;
}
