namespace Harvester.Capture.Ports;

/// <summary>Stops a game's world and lets it go on. The game goes on ticking and rendering while its world stands still.</summary>
public interface IPause
{
    /// <summary>Asks the game to stop its world; it may take some ticks until everything stands still. Again is no harm.</summary>
    void Freeze();

    /// <summary>Lets the world go on. Again is no harm.</summary>
    void Unfreeze();
}
