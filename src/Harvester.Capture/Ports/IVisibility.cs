namespace Harvester.Capture.Ports;

/// <summary>
/// Hides entities of a game from its pictures, for coded masks. Hiding changes nothing else: the entity stays where it is, keeps its
/// collision, and rays still hit it. All calls come from the game's own thread; exceptions pass through and end the harvest, which then
/// calls <see cref="ShowAll"/>.
/// </summary>
public interface IVisibility
{
    /// <summary>
    /// Announces the entities that are going to be hidden. Nothing may be hidden before this has returned them. A game whose script may
    /// crash first writes them to disk, so that the next start can show them again, and needs several ticks for that.
    /// </summary>
    /// <param name="entities">Handles of the entities.</param>
    /// <returns>
    /// Those of them that may be hidden: they exist, and no one else has hidden them. Null if the game is not ready yet; the call is then
    /// repeated in the next tick with the same entities.
    /// </returns>
    IReadOnlyCollection<int>? Announce(IReadOnlyCollection<int> entities);

    /// <summary>
    /// Hides these entities, and shows all others that were announced. It takes effect in one of the next pictures. An entity that
    /// has vanished meanwhile is skipped.
    /// </summary>
    /// <param name="entities">Handles of entities that <see cref="Announce"/> returned.</param>
    void HideOnly(IReadOnlyCollection<int> entities);

    /// <summary>Shows everything that was hidden, and ends the announcement. Calling it again has no effect.</summary>
    void ShowAll();
}
