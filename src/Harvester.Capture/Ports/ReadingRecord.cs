namespace Harvester.Capture.Ports;

/// <summary>Records what could not be read of a game correctly. The game's reader fills it; a harvest resets and reports it.</summary>
public sealed class ReadingRecord
{
    private readonly HashSet<int> _distorted = [];
    private readonly HashSet<EntityKind> _listedByNatives = [];

    /// <summary>The part that a session records.</summary>
    public ReadingReport Report => new(SourceOf(EntityKind.Vehicle), SourceOf(EntityKind.Ped), SourceOf(EntityKind.Prop), _distorted.Count);

    /// <summary>Resets the counters. The sources of the lists are kept.</summary>
    public void Begin() => _distorted.Clear();

    /// <summary>Counts an entity that was left out because its matrix is sheared or mirrored; each once.</summary>
    public void AddDistorted(int entity) => _distorted.Add(entity);

    /// <summary>Records that entities of a kind are listed by natives from now on.</summary>
    public void ListByNatives(EntityKind kind) => _listedByNatives.Add(kind);

    /// <summary>Where the list of entities of a kind comes from.</summary>
    public ListSource SourceOf(EntityKind kind) => _listedByNatives.Contains(kind) ? ListSource.Natives : ListSource.Api;
}
