namespace Harvester.Capture.Ports;

/// <summary>Freezes and resumes a game's world. The game keeps ticking and rendering while its world is frozen.</summary>
public interface IPause
{
    /// <summary>The method of the next freeze. A world that is already frozen is resumed by the method with which it was frozen.</summary>
    FreezeMethod Method { get; set; }

    /// <summary>
    /// Asks the game to freeze its world; it may take some ticks until everything stands still. Calling it again has no effect.
    /// </summary>
    void Freeze();

    /// <summary>Resumes the world. Calling it again has no effect.</summary>
    void Unfreeze();
}
