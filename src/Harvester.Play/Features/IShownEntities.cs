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

    /// <summary>Shows or hides an entity.</summary>
    void Show(int entity, bool isShown);
}
