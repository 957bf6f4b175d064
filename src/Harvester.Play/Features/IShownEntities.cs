namespace Harvester.Play.Features;

/// <summary>Whether the game draws its entities.</summary>
public interface IShownEntities
{
    /// <summary>Number of the game's process and when it started: handles of another process mean nothing in this one.</summary>
    string Process { get; }

    /// <summary>Whether an entity exists.</summary>
    bool Exists(int entity);

    /// <summary>Whether the game may draw an entity.</summary>
    bool IsShown(int entity);

    /// <summary>
    /// What moves with entities and stays in the picture when only they are hidden, such as the occupants of a vehicle, by the entity.
    /// </summary>
    /// <param name="entities">Entities that exist.</param>
    ILookup<int, int> GroupsOf(IReadOnlyCollection<int> entities);

    /// <summary>Shows or hides an entity alone.</summary>
    void Show(int entity, bool isShown);
}
