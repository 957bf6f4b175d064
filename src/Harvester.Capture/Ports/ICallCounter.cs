namespace Harvester.Capture.Ports;

/// <summary>Counts the calls to the game since its start. Neither count decreases.</summary>
public interface ICallCounter
{
    /// <summary>Calls of the game's native functions, including those for rays.</summary>
    long Natives { get; }

    /// <summary>Number of rays cast since the start of the game.</summary>
    long Rays { get; }
}
