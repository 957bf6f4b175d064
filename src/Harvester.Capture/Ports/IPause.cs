namespace Harvester.Capture.Ports;

/// <summary>Stops a game's world and lets it go on. The game goes on ticking and rendering while its world stands still.</summary>
public interface IPause
{
    /// <summary>How the next freeze stops the world. A world that is frozen already is let go in the way it was stopped.</summary>
    FreezeMethod Method { get; set; }

    /// <summary>
    /// Asks the game to stop its world; it may take some ticks until everything stands still. Calling it again has no effect.
    /// </summary>
    void Freeze();

    /// <summary>Lets the world go on. Calling it again has no effect.</summary>
    void Unfreeze();
}
