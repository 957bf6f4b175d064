namespace Harvester.Capture.Ports;

/// <summary>Counts what was asked of the game since its start. Neither count ever falls.</summary>
public interface ICallCounter
{
    /// <summary>Calls of the game's native functions, those of rays included.</summary>
    long Natives { get; }

    /// <summary>Number of rays cast since the start of the game.</summary>
    long Rays { get; }
}
